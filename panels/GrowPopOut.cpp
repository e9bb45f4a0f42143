// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/GrowPopOut.h"

#include "commands/EditTitle.h"
#include "panels/Icon.h"
#include "panels/Theme.h"
#include "panels/TimeSlider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

GrowPopOut::GrowPopOut(const TreeDocument& document, QWidget* parent)
    : Bar(parent),
      m_document(document),
      m_time(new TimeSlider(this)),
      m_play(new QPushButton(icon(QStringLiteral("play")), {}, this)),
      m_step(new QLabel(this)),
      m_title(new QLabel(this)),
      m_count(new QSpinBox(this))
{
    m_time->setObjectName(QStringLiteral("time"));
    m_time->setAccessibleName(tr("Time"));
    m_time->setToolTip(tr(
        "Back: the tree ungrows, through all that you did. Forth: it comes back. Pull the handle well past "
        "the mark, and the tree grows. Far from the slider, or with Shift, a drag is finer."));
    m_play->setObjectName(QStringLiteral("playTime"));
    m_play->setCheckable(true);
    m_play->setFixedSize(theme::kTarget, theme::kTarget);
    m_play->setAccessibleName(tr("Play"));
    m_play->setToolTip(tr("Play what happened from here on, or all of it."));
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
    for (QLabel* label : {m_step, m_title}) {
        label->setAlignment(Qt::AlignCenter);
        label->setTextFormat(Qt::PlainText);
        // A long text makes nothing wider.
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        theme::setTone(*label, theme::Tone::Dim);
    }
    m_step->setObjectName(QStringLiteral("timeStep"));
    m_title->setObjectName(QStringLiteral("timeTitle"));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 10);
    column->setSpacing(8);
    auto* time = new QHBoxLayout;
    time->setSpacing(6);
    time->addWidget(m_play);
    time->addWidget(m_time, 1);
    column->addLayout(time);
    auto* moment = new QVBoxLayout;
    moment->setSpacing(0);
    moment->addWidget(m_step);
    moment->addWidget(m_title);
    column->addLayout(moment);
    column->addWidget(hold);
    auto* line = new QHBoxLayout;
    line->addWidget(m_count);
    line->addWidget(many, 1);
    column->addLayout(line);

    connect(hold, &QPushButton::pressed, this, &GrowPopOut::holdBegins);
    connect(hold, &QPushButton::released, this, &GrowPopOut::holdEnds);
    connect(many, &QPushButton::clicked, this, [this] { Q_EMIT stepsAsked(m_count->value()); });
    connect(m_time, &TimeSlider::moved, this, &GrowPopOut::timeMoved);
    connect(m_time, &TimeSlider::letGo, this, [this] {
        Q_EMIT timeReleased();
        showStep();
    });
    connect(m_time, &TimeSlider::cancelled, this, &GrowPopOut::timeCancelled);
    connect(m_play, &QPushButton::toggled, this, &GrowPopOut::playToggled);
    connect(&document, &TreeDocument::changed, this, &GrowPopOut::showStep);
    // An edit gets its name at its end.
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, &GrowPopOut::showStep);
    showStep();
}

void GrowPopOut::showStep()
{
    const auto here = static_cast<int>(m_document.journal().size());
    // While the user holds the slider it leads the history; otherwise it follows.
    if (!m_time->isSliderDown())
        m_time->setHistory(here, here + static_cast<int>(m_document.future().size()));
    const int present = m_time->maximum();
    m_step->setText(here > present ? tr("New steps: %L1").arg(here - present)
                                   : tr("Moment %L1 of %L2").arg(here).arg(present));
    m_title->setText(titleOfMoment());
}

QString GrowPopOut::titleOfMoment()
{
    const Journal& journal = m_document.journal();
    // An edit's first delta alone has the record; nothing to look for while the same edit grows on.
    const auto first = std::find_if(journal.rbegin(), journal.rend(),
                                    [](const auto& delta) { return delta->record != nullptr; });
    if (first == journal.rend())
        return journal.empty() ? tr("Seedling") : QString();
    return titleOfEdit(*(*first)->record);
}

void GrowPopOut::stopDrag()
{
    m_time->drop();
    showStep();
}

void GrowPopOut::setPlaying(bool plays)
{
    const QSignalBlocker blocker(m_play);
    m_play->setChecked(plays);
}

} // namespace espalier
