// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/PrunePopOut.h"

#include "panels/Theme.h"
#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QButtonGroup>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

namespace {

constexpr int kPruneWidth = 156; ///< px

constexpr ViewField kPruneRadius{
    {"view.brushRadius", Quantity::Metres, 0, kMaxBrushRadius},
    {"view.brushRadius", QT_TRANSLATE_NOOP("Parameters", "Radius"), "",
     QT_TRANSLATE_NOOP("Parameters", "Radius of the brush, shared with the Brush tool."),
     ParameterText::Scale::Cubic, 1, "cm", 100.0},
    [](const ViewValues& values) { return values.brushRadius; },
    [](ViewValues& values, double value) { values.brushRadius = value; }};

constexpr ViewField kEraserThickest{
    {"view.eraserThickest", Quantity::Number, kLeastThickest, 1},
    {"view.eraserThickest", QT_TRANSLATE_NOOP("Parameters", "Up to"), "",
     QT_TRANSLATE_NOOP("Parameters", "The thickest wood that is removed, as a share of the trunk's width. "
                                     "Thicker branches stay, however often you brush over them."),
     ParameterText::Scale::Linear, 0, "%", 100.0},
    [](const ViewValues& values) { return values.eraserThickest; },
    [](ViewValues& values, double value) { values.eraserThickest = value; }};

constexpr ViewField kThinShareField{
    {"view.thinShare", Quantity::Number, kLeastThinShare, 1},
    {"view.thinShare", QT_TRANSLATE_NOOP("Parameters", "Share of twigs"), "",
     QT_TRANSLATE_NOOP("Parameters", "The share of the twigs under the brush that a stroke takes. They are "
                                     "chosen evenly along each limb."),
     ParameterText::Scale::Linear, 0, "%", 100.0},
    [](const ViewValues& values) { return values.thinShare; },
    [](ViewValues& values, double value) { values.thinShare = value; }};

constexpr ViewField kPrunesThrough = viewSwitch<&ViewValues::prunesThrough>(
    "view.prunesThrough", QT_TRANSLATE_NOOP("Parameters", "Far side too"),
    QT_TRANSLATE_NOOP("Parameters",
                      "A stroke reaches through the whole tree. Otherwise it takes only what is "
                      "on your side of the trunk."));

struct ModeTexts {
    const char* name;
    const char* text;
    const char* tip;
};
// In the order of PruneMode
constexpr std::array<ModeTexts, kPruneModeCount> kModes{{
    {"pruneCut", QT_TRANSLATE_NOOP("espalier::PrunePopOut", "Cut"),
     QT_TRANSLATE_NOOP("espalier::PrunePopOut",
                       "Tap a branch to cut it off, or draw a line across several.")},
    {"pruneKeepClear", QT_TRANSLATE_NOOP("espalier::PrunePopOut", "Keep clear"),
     QT_TRANSLATE_NOOP("espalier::PrunePopOut",
                       "Drag up along a trunk or a branch: the shoots below your hand are removed, and no "
                       "new ones come. Drag the ring down again to let buds shoot.")},
    {"pruneErase", QT_TRANSLATE_NOOP("espalier::PrunePopOut", "Erase"),
     QT_TRANSLATE_NOOP("espalier::PrunePopOut",
                       "Brush over twigs and leaves to take them away, however deep in the "
                       "crown they are. Limbs stay.")},
    {"pruneThin", QT_TRANSLATE_NOOP("espalier::PrunePopOut", "Thin out"),
     QT_TRANSLATE_NOOP("espalier::PrunePopOut",
                       "Brush over the crown to take out some of its twigs evenly.")},
}};

} // namespace

PrunePopOut::PrunePopOut(ViewSettings& settings, QWidget* parent) : Bar(parent), m_settings(settings)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 12, 14, 8);
    column->setSpacing(4);
    auto* group = new QButtonGroup(this);
    for (std::size_t i = 0; i < kModes.size(); ++i) {
        auto* button = new QPushButton(tr(kModes[i].text), this);
        button->setObjectName(QString::fromLatin1(kModes[i].name));
        button->setToolTip(QStringLiteral("<b>%1</b><br>%2").arg(button->text(), tr(kModes[i].tip)));
        button->setCheckable(true);
        button->setMinimumHeight(theme::kTarget);
        button->setFocusPolicy(Qt::TabFocus);
        button->setProperty("choice", true);
        group->addButton(button, static_cast<int>(i));
        column->addWidget(button);
        m_modes[i] = button;
    }
    column->addSpacing(4);
    using enum PruneMode;
    const std::pair<const ViewField*, std::vector<PruneMode>> fields[] = {
        {&kPruneRadius, {Erase, Thin}},
        {&kThinShareField, {Thin}},
        {&kEraserThickest, {Erase, Thin}},
        {&kPrunesThrough, {Cut, Erase, Thin}},
    };
    for (const auto& [field, modes] : fields) {
        ViewRow* row = makeViewRow(*field, settings, this);
        row->setFixedWidth(kPruneWidth);
        column->addWidget(row);
        m_controls.push_back({row, modes});
    }
    connect(group, &QButtonGroup::idClicked, this,
            [this](int id) { m_settings.set(&ViewValues::pruneMode, static_cast<PruneMode>(id)); });
    connect(&settings, &ViewSettings::changed, this, [this] {
        if (!m_modes[static_cast<std::size_t>(m_settings.values().pruneMode)]->isChecked())
            showMode();
    });
    connect(group, &QButtonGroup::idToggled, this, [this](int, bool isOn) {
        if (isOn)
            showMode();
    });
    showMode();
}

void PrunePopOut::showMode()
{
    const PruneMode mode = m_settings.values().pruneMode;
    m_modes[static_cast<std::size_t>(mode)]->setChecked(true);
    for (const Control& control : m_controls)
        control.row->setVisible(std::ranges::find(control.modes, mode) != control.modes.end());
    layout()->activate();
    updateGeometry();
    Q_EMIT sizeWanted();
}

} // namespace espalier
