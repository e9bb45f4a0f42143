// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/GrowPopOut.h"

#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace espalier {

GrowPopOut::GrowPopOut(const TreeDocument& document, QWidget* parent)
    : Bar(parent), m_document(document), m_step(new QLabel(this)), m_count(new QSpinBox(this))
{
    auto* hold = new QPushButton(icon(QStringLiteral("grow")), tr("Hold to grow"), this);
    hold->setObjectName(QStringLiteral("holdToGrow"));
    hold->setIconSize({24, 24});
    hold->setMinimumHeight(theme::kTarget + 8);
    hold->setFocusPolicy(Qt::TabFocus);
    hold->setToolTip(tr("A tap grows one step; hold to grow on. One hold is one undo step."));
    m_count->setRange(1, 1000);
    m_count->setValue(10);
    m_count->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_count->setMinimumHeight(theme::kTarget - 8);
    m_count->setFocusPolicy(Qt::ClickFocus);
    m_count->setAlignment(Qt::AlignRight);
    m_count->setAccessibleName(tr("Steps to grow"));
    auto* many = new QPushButton(tr("steps"), this);
    many->setObjectName(QStringLiteral("growSteps"));
    many->setMinimumHeight(theme::kTarget - 8);
    many->setFocusPolicy(Qt::TabFocus);
    many->setToolTip(tr("Grow that many steps, as one undo step. Escape stops."));
    m_step->setAlignment(Qt::AlignCenter);
    QPalette dim = m_step->palette();
    dim.setColor(QPalette::WindowText, theme::kDimText);
    m_step->setPalette(dim);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 10);
    column->setSpacing(8);
    column->addWidget(hold);
    auto* line = new QHBoxLayout;
    line->addWidget(m_count);
    line->addWidget(many, 1);
    column->addLayout(line);
    column->addWidget(m_step);

    connect(hold, &QPushButton::pressed, this, &GrowPopOut::holdBegins);
    connect(hold, &QPushButton::released, this, &GrowPopOut::holdEnds);
    connect(many, &QPushButton::clicked, this, [this] { Q_EMIT stepsAsked(m_count->value()); });
    connect(&document, &TreeDocument::changed, this, &GrowPopOut::showStep);
    showStep();
}

void GrowPopOut::showStep()
{
    m_step->setText(tr("step %L1").arg(m_document.tree().step()));
}

} // namespace espalier
