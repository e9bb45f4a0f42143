// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/SketchPopOut.h"

#include "panels/Theme.h"
#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kSketchWidth = 164; ///< px

constexpr ViewField kSketchCuts = viewSwitch<&ViewValues::sketchCuts>(
    "view.sketchCuts", QT_TRANSLATE_NOOP("Parameters", "Take away"),
    QT_TRANSLATE_NOOP("Parameters",
                      "A stroke takes away: a branch that it crosses once is cut there, one that it "
                      "crosses twice is erased. Shift or a pen's eraser does so, too."));
constexpr ViewField kSketchSides = viewSwitch<&ViewValues::sketchSides>(
    "view.sketchSides", QT_TRANSLATE_NOOP("Parameters", "Two sides"),
    QT_TRANSLATE_NOOP("Parameters", "Two strokes in a row, drawn side by side, are the two sides of one "
                                    "branch, which gets its width from them."));
constexpr ViewField kSketchMirror = viewSwitch<&ViewValues::sketchMirror>(
    "view.sketchMirror", QT_TRANSLATE_NOOP("Parameters", "Mirror"),
    QT_TRANSLATE_NOOP("Parameters", "Each branch is drawn on the other side of the trunk as well."));
constexpr ViewField kSecondTree = viewSwitch<&ViewValues::secondTree>(
    "view.secondTree", QT_TRANSLATE_NOOP("Parameters", "Fill the sides"),
    QT_TRANSLATE_NOOP("Parameters",
                      "The drawing is placed twice, the second time turned by 90° around the trunk, so that "
                      "the tree is as full from the side as from the front. Without this, its branches "
                      "themselves run towards you and away from you."));

template <double ViewValues::*Member>
constexpr ViewField magnification(const char* key, const char* label, const char* tip)
{
    return {{key, Quantity::Number, kLeastDepthFactor, kMostDepthFactor},
            {key, label, "", tip, ParameterText::Scale::Linear, 2},
            [](const ViewValues& values) { return values.*Member; },
            [](ViewValues& values, double value) { values.*Member = value; }};
}

constexpr ViewField kMagnifications[] = {
    magnification<&ViewValues::depthHull>(
        "view.depthHull", QT_TRANSLATE_NOOP("Parameters", "Crown"),
        QT_TRANSLATE_NOOP("Parameters", "How much wider than the drawing the crown may be in depth.")),
    magnification<&ViewValues::depthLength>(
        "view.depthLength", QT_TRANSLATE_NOOP("Parameters", "Lengths"),
        QT_TRANSLATE_NOOP("Parameters", "How much longer branches may become in depth than those you drew.")),
    magnification<&ViewValues::depthAngle>(
        "view.depthAngle", QT_TRANSLATE_NOOP("Parameters", "Angles"),
        QT_TRANSLATE_NOOP("Parameters",
                          "How much wider an angle between branches may be than the widest you drew.")),
};

QPushButton* addButton(const QString& name, const QString& text, const QString& tip, QVBoxLayout* column)
{
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setMinimumHeight(theme::kTarget);
    button->setFocusPolicy(Qt::TabFocus);
    column->addWidget(button);
    return button;
}

} // namespace

SketchPopOut::SketchPopOut(ViewSettings& settings, QWidget* parent) : Bar(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 10, 14, 8);
    column->setSpacing(4);
    const auto addRow = [&](const ViewField& field) {
        ViewRow* row = makeViewRow(field, settings, this);
        row->setFixedWidth(kSketchWidth);
        column->addWidget(row);
    };
    addRow(kSketchCuts);
    addRow(kSketchSides);
    addRow(kSketchMirror);
    m_give = addButton(
        QStringLiteral("giveDepth"), tr("Give depth"),
        tr("<b>Give depth</b><br>The branches of the drawing spread into depth, as far from each other "
           "as they can. From the front the tree looks as you drew it."),
        column);
    m_other = addButton(QStringLiteral("otherDepth"), tr("Another depth"),
                        tr("<b>Another depth</b><br>Choose new depths for the branches."), column);
    addRow(kSecondTree);
    for (const ViewField& field : kMagnifications)
        addRow(field);
    connect(m_give, &QPushButton::clicked, this, &SketchPopOut::depthAsked);
    connect(m_other, &QPushButton::clicked, this, &SketchPopOut::otherDepthAsked);
    setDepth(false, false);
}

void SketchPopOut::setDepth(bool mayGive, bool isGiven)
{
    m_give->setEnabled(mayGive);
    m_other->setEnabled(isGiven);
}

} // namespace espalier
