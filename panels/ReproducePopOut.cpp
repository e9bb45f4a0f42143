// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ReproducePopOut.h"

#include "panels/Theme.h"
#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kReproduceWidth = 176; ///< px
constexpr int kHintLines = 3;

constexpr ViewField kVariation{
    {"view.variation", Quantity::Number, kLeastVariation, 1.0},
    {"view.variation", QT_TRANSLATE_NOOP("Parameters", "Variation"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How much the angles and lengths of a variation deviate from those of the tree."),
     ParameterText::Scale::Linear, 0, "%", 100.0},
    [](const ViewValues& values) { return values.variation; },
    [](ViewValues& values, double value) { values.variation = value; }};

constexpr ViewField kVariationNumber{
    {"view.variationNumber", Quantity::Count, 1.0, kMostVariations},
    {"view.variationNumber", QT_TRANSLATE_NOOP("Parameters", "Number"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "Which variation it is: the same number always gives the same variation of a tree."),
     ParameterText::Scale::Linear, 0},
    [](const ViewValues& values) { return values.variationNumber; },
    [](ViewValues& values, double value) { values.variationNumber = value; }};

} // namespace

ReproducePopOut::ReproducePopOut(ViewSettings& settings, QWidget* parent)
    : Bar(parent), m_hint(new QLabel(this)), m_other(new QPushButton(tr("Another"), this))
{
    m_hint->setObjectName(QStringLiteral("figureHint"));
    m_hint->setWordWrap(true);
    m_hint->setFixedWidth(kReproduceWidth);
    // The controls below stay where they are while the hint changes.
    m_hint->setFixedHeight(kHintLines * m_hint->fontMetrics().lineSpacing());
    m_hint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_other->setObjectName(QStringLiteral("otherVariation"));
    m_other->setToolTip(
        tr("<b>Another</b><br>The same tree with slightly different angles and lengths, as it "
           "could stand beside it in a forest. As long as nothing else is done, the next one "
           "takes its place."));
    m_other->setMinimumHeight(theme::kTarget);
    m_other->setFocusPolicy(Qt::TabFocus);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 12, 14, 12);
    column->setSpacing(6);
    column->addWidget(m_hint);
    for (const ViewField* field : {&kVariation, &kVariationNumber}) {
        ViewRow* row = makeViewRow(*field, settings, this);
        row->setFixedWidth(kReproduceWidth);
        column->addWidget(row);
    }
    column->addWidget(m_other);
    connect(m_other, &QPushButton::clicked, this, &ReproducePopOut::otherAsked);
}

void ReproducePopOut::setHint(const QString& hint)
{
    m_hint->setText(hint);
}

void ReproducePopOut::setMayVary(bool may)
{
    m_other->setEnabled(may);
}

} // namespace espalier
