// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/GrowPopOut.h"

#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

namespace espalier {

namespace {

/// Number of growth steps beyond the present that the slider reaches at least.
constexpr int kGrowthZone = 12;
/// Width of the present on the slider, px: moving the handle there, or only touching it, grows nothing.
constexpr int kDetent = 6;

} // namespace

GrowPopOut::GrowPopOut(const TreeDocument& document, QWidget* parent)
    : Bar(parent),
      m_document(document),
      m_time(new QSlider(Qt::Horizontal, this)),
      m_play(new QPushButton(icon(QStringLiteral("play")), {}, this)),
      m_step(new QLabel(this)),
      m_count(new QSpinBox(this))
{
    m_time->setObjectName(QStringLiteral("time"));
    m_time->setMinimumSize(170, theme::kTarget);
    m_time->setAccessibleName(tr("Time"));
    m_time->setToolTip(
        tr("Back: the tree ungrows, through all that you did. Forth: it comes back, and beyond the "
           "mark it grows."));
    m_play->setObjectName(QStringLiteral("playTime"));
    m_play->setCheckable(true);
    m_play->setFixedSize(theme::kTarget, theme::kTarget);
    m_play->setAccessibleName(tr("Play"));
    m_play->setToolTip(tr("Play what happened from here on, or all of it"));
    m_play->setFocusPolicy(Qt::TabFocus);
    auto* hold = new QPushButton(icon(QStringLiteral("grow")), tr("Hold to grow"), this);
    hold->setObjectName(QStringLiteral("holdToGrow"));
    hold->setIconSize({24, 24});
    hold->setMinimumHeight(theme::kTarget + 8);
    hold->setFocusPolicy(Qt::TabFocus);
    hold->setToolTip(tr("A tap grows one step; hold to grow on. One hold is one undo step."));
    m_count->setRange(1, 1000);
    m_count->setValue(10);
    m_count->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_count->setMinimumHeight(theme::kTarget);
    m_count->setFocusPolicy(Qt::StrongFocus);
    m_count->setAlignment(Qt::AlignRight);
    m_count->setAccessibleName(tr("Steps to grow"));
    auto* many = new QPushButton(tr("steps"), this);
    many->setObjectName(QStringLiteral("growSteps"));
    many->setMinimumHeight(theme::kTarget);
    many->setFocusPolicy(Qt::TabFocus);
    many->setToolTip(tr("Grow that many steps, as one undo step. Escape stops."));
    m_step->setAlignment(Qt::AlignCenter);
    theme::setTone(*m_step, theme::Tone::Dim);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 10);
    column->setSpacing(8);
    auto* time = new QHBoxLayout;
    time->setSpacing(6);
    time->addWidget(m_play);
    time->addWidget(m_time, 1);
    column->addLayout(time);
    column->addWidget(m_step);
    column->addWidget(hold);
    auto* line = new QHBoxLayout;
    line->addWidget(m_count);
    line->addWidget(many, 1);
    column->addLayout(line);

    connect(hold, &QPushButton::pressed, this, &GrowPopOut::holdBegins);
    connect(hold, &QPushButton::released, this, &GrowPopOut::holdEnds);
    connect(many, &QPushButton::clicked, this, [this] { Q_EMIT stepsAsked(m_count->value()); });
    connect(m_time, &QSlider::valueChanged, this, [this](int position) {
        Q_EMIT timeMoved(m_time->isSliderDown() ? detained(position) : position);
        // Keys, and clicks beside the handle, are whole gestures.
        if (!m_time->isSliderDown())
            Q_EMIT timeReleased();
    });
    connect(m_time, &QSlider::sliderReleased, this, [this] {
        Q_EMIT timeReleased();
        showStep();
    });
    connect(m_play, &QPushButton::toggled, this, &GrowPopOut::playToggled);
    connect(&document, &TreeDocument::changed, this, &GrowPopOut::showStep);
    showStep();
}

void GrowPopOut::showStep()
{
    m_step->setText(m_document.future().empty() ? tr("step %L1").arg(m_document.tree().step())
                                                : tr("step %L1, %L2 edits and steps back")
                                                      .arg(m_document.tree().step())
                                                      .arg(m_document.future().size()));
    // While the user holds the slider it leads the history; otherwise it follows.
    if (m_time->isSliderDown())
        return;
    const QSignalBlocker blocker(m_time);
    const auto here = static_cast<int>(m_document.journal().size());
    m_present = here + static_cast<int>(m_document.future().size());
    m_time->setRange(0, m_present + std::max(kGrowthZone, m_present / 8));
    m_time->setPageStep(std::max(1, m_present / 20));
    m_time->setValue(here);
}

int GrowPopOut::detained(int position) const
{
    const int held = m_time->maximum() * kDetent / std::max(1, m_time->width()) + 1;
    return position > m_present ? std::max(m_present, position - held) : position;
}

void GrowPopOut::setPlaying(bool plays)
{
    const QSignalBlocker blocker(m_play);
    m_play->setChecked(plays);
}

} // namespace espalier
