// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/BackgroundPanel.h"

#include "panels/Sideways.h"
#include "panels/Theme.h"
#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>
#include <cstring>

namespace espalier {

namespace {

template <double TracingImage::*Member>
constexpr ViewField tracingField(const char* key, const char* label, const char* tip, double least,
                                 double most, ParameterText::Scale scale, const char* unit)
{
    return {{key, *unit == '\0' ? Quantity::Number : Quantity::Metres, least, most},
            {key, label, "", tip, scale, 2, unit},
            [](const ViewValues& values) { return values.tracing.*Member; },
            [](ViewValues& values, double value) { values.tracing.*Member = value; }};
}

/// Azimuth of the sun that the row shows, −180...180
double shownAzimuth(const ViewValues& values)
{
    return std::remainder(degrees(values.sunAzimuth), 360.0);
}

constexpr auto kLinear = ParameterText::Scale::Linear;
constexpr auto kLogarithmic = ParameterText::Scale::Logarithmic;
// Widths of columns, px; a window of 1024 has room for all.
constexpr int kBehindWidth = 190;
constexpr int kGroundWidth = 112;
constexpr int kSunWidth = 160;
constexpr int kTracingWidth = 118;
constexpr int kPlaceWidth = 150;
constexpr int kSpacing = 18;
constexpr double kMostTracing = 20.0; ///< m; the limit of the sliders

// In columns, from left to right.
enum FieldPlace : std::size_t {
    BackdropField,
    GroundField,
    GridField,
    ShadowsField,
    SunShownField,
    SunPinnedField,
    AzimuthField,
    ElevationField,
    OpacityField,
    HeightField,
    RightField,
    UpField,
    FieldCount
};

constexpr std::array<ViewField, FieldCount> kFields{{
    {{"view.backdrop", Quantity::Choice, 0, kBackdropCount - 1, kBackdropNames},
     {"view.backdrop", QT_TRANSLATE_NOOP("Parameters", "Backdrop"), "",
      QT_TRANSLATE_NOOP("Parameters",
                        "What stands behind the tree. The studio is dark or light, as the theme is.")},
     [](const ViewValues& values) { return static_cast<double>(values.backdrop); },
     [](ViewValues& values, double value) {
         values.backdrop = static_cast<Backdrop>(static_cast<int>(value));
     }},
    viewSwitch<&ViewValues::groundShown>(
        "view.groundShown", QT_TRANSLATE_NOOP("Parameters", "Ground"),
        QT_TRANSLATE_NOOP("Parameters", "Ground below the tree, with the tree's shadow.")),
    viewSwitch<&ViewValues::gridShown>(
        "view.gridShown", QT_TRANSLATE_NOOP("Parameters", "Grid"),
        QT_TRANSLATE_NOOP("Parameters", "Lines on the ground, a metre apart.")),
    viewSwitch<&ViewValues::shadowsShown>("view.shadowsShown", QT_TRANSLATE_NOOP("Parameters", "Shadows"),
                                          QT_TRANSLATE_NOOP("Parameters", "Shadows of the sun.")),
    viewSwitch<&ViewValues::sunShown>(
        "view.sunShown", QT_TRANSLATE_NOOP("Parameters", "Show the sun"),
        QT_TRANSLATE_NOOP("Parameters", "Show the sun as a ball that you can drag around the tree.")),
    viewSwitch<&ViewValues::sunPinned>(
        "view.sunPinned", QT_TRANSLATE_NOOP("Parameters", "Pin the sun"),
        QT_TRANSLATE_NOOP("Parameters", "The sun stays where it is on the screen when the tree is turned; "
                                        "otherwise it turns with the tree.")),
    {{"view.sunAzimuth", Quantity::Angle, -180, 180},
     {"view.sunAzimuth", QT_TRANSLATE_NOOP("Parameters", "Direction"), "",
      QT_TRANSLATE_NOOP("Parameters", "Where the sun stands: 0° in front of the tree, 90° to its right; for "
                                      "a pinned sun, as seen on the screen."),
      kLinear, 0, "°"},
     shownAzimuth,
     [](ViewValues& values, double value) { values.sunAzimuth = radians(value); }},
    {{"view.sunElevation", Quantity::Angle, 5, 90},
     {"view.sunElevation", QT_TRANSLATE_NOOP("Parameters", "Height"), "",
      QT_TRANSLATE_NOOP("Parameters", "How high the sun stands above the horizon."), kLinear, 0, "°"},
     [](const ViewValues& values) { return degrees(values.sunElevation); },
     [](ViewValues& values, double value) { values.sunElevation = radians(value); }},
    tracingField<&TracingImage::opacity>("view.tracing.opacity", QT_TRANSLATE_NOOP("Parameters", "Opacity"),
                                         QT_TRANSLATE_NOOP("Parameters", "How opaque the picture is."), 0, 1,
                                         kLinear, ""),
    tracingField<&TracingImage::height>("view.tracing.height", QT_TRANSLATE_NOOP("Parameters", "Height"),
                                        QT_TRANSLATE_NOOP("Parameters", "How tall the picture is."), 0.1,
                                        TracingImage::kMaxHeight, kLogarithmic, "m"),
    tracingField<&TracingImage::right>(
        "view.tracing.right", QT_TRANSLATE_NOOP("Parameters", "To the right"),
        QT_TRANSLATE_NOOP("Parameters", "How far the picture's middle is to the right of the seedling."),
        -kMostTracing, kMostTracing, kLinear, "m"),
    tracingField<&TracingImage::up>(
        "view.tracing.up", QT_TRANSLATE_NOOP("Parameters", "Up"),
        QT_TRANSLATE_NOOP("Parameters", "How far the picture's middle is above the seedling."), -kMostTracing,
        kMostTracing, kLinear, "m"),
}};

// The names for choiceNames()
[[maybe_unused]] constexpr const char* kChoiceNames[] = {
    QT_TRANSLATE_NOOP("Parameters", "studio"),      QT_TRANSLATE_NOOP("Parameters", "horizon"),
    QT_TRANSLATE_NOOP("Parameters", "plain"),       QT_TRANSLATE_NOOP("Parameters", "gradient"),
    QT_TRANSLATE_NOOP("Parameters", "dark_studio"), QT_TRANSLATE_NOOP("Parameters", "light_studio")};

QIcon swatch(const QColor& colour)
{
    QPixmap pixmap(18, 18);
    pixmap.fill(colour);
    return pixmap;
}

QPushButton* makeButton(const QString& text, const char* name, QVBoxLayout& column, QWidget* parent)
{
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setMinimumHeight(theme::kTarget);
    button->setFocusPolicy(Qt::TabFocus);
    column.addWidget(button);
    return button;
}

} // namespace

BackgroundPanel::BackgroundPanel(ViewSettings& settings, QWidget* parent)
    : Bar(parent), m_settings(settings), m_content(new QWidget), m_rows(FieldCount, nullptr)
{
    auto* columns = new QHBoxLayout(m_content);
    columns->setContentsMargins(20, 14, 20, 12);
    columns->setSpacing(kSpacing);

    QVBoxLayout* behind = addBarColumn(*m_content, tr("Background"), kBehindWidth);
    addRow(*behind, BackdropField);
    m_colour =
        addColour(*behind, "backgroundColour", tr("The colour of the background, or of its lower edge."),
                  &ViewValues::backgroundColour);
    m_topColour =
        addColour(*behind, "backgroundTop", tr("The colour at the upper edge."), &ViewValues::backgroundTop);
    m_useForNew = makeButton(tr("Use for New Trees"), "lookForNewTrees", *behind, behind->parentWidget());
    m_useForNew->setToolTip(
        tr("New trees begin with this background, ground and light. The picture stays with this tree."));
    connect(m_useForNew, &QPushButton::clicked, this, &BackgroundPanel::lookForNewTreesAsked);
    QVBoxLayout* ground = addBarColumn(*m_content, tr("Ground"), kGroundWidth);
    for (const FieldPlace field : {GroundField, GridField, ShadowsField})
        addRow(*ground, field);
    QVBoxLayout* sun = addBarColumn(*m_content, tr("Sun"), kSunWidth);
    for (const FieldPlace field : {SunShownField, SunPinnedField, AzimuthField, ElevationField})
        addRow(*sun, field);
    addTracing(*addBarColumn(*m_content, tr("Reference picture"), kTracingWidth + kSpacing + kPlaceWidth));
    for (QVBoxLayout* column : {behind, ground, sun})
        column->addStretch();

    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(1, 1, 1, 1);
    whole->addWidget(new Sideways(m_content, this));
    connect(&settings, &ViewSettings::changed, this, &BackgroundPanel::showValues);
    showValues();
}

void BackgroundPanel::addRow(QVBoxLayout& column, std::size_t field)
{
    m_rows[field] = makeViewRow(kFields[field], m_settings, column.parentWidget());
    column.addWidget(m_rows[field]);
}

QPushButton* BackgroundPanel::addColour(QVBoxLayout& column, const char* name, const QString& toolTip,
                                        QColor ViewValues::*colour)
{
    QPushButton* button = makeButton({}, name, column, column.parentWidget());
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    connect(button, &QPushButton::clicked, this, [this, colour] { askForColour(colour); });
    return button;
}

void BackgroundPanel::addTracing(QVBoxLayout& column)
{
    QWidget* parent = column.parentWidget();
    auto* line = new QHBoxLayout;
    line->setSpacing(kSpacing);
    column.addLayout(line);
    auto* file = new QVBoxLayout;
    line->addLayout(file);
    QPushButton* choose = makeButton(tr("Choose…"), "tracingChoose", *file, parent);
    choose->setToolTip(
        tr("Choose a picture to show behind the tree while you draw. It is saved with the tree."));
    connect(choose, &QPushButton::clicked, this, &BackgroundPanel::pictureAsked);
    m_remove = makeButton(tr("Remove"), "tracingRemove", *file, parent);
    m_remove->setToolTip(tr("Show no picture behind the tree."));
    connect(m_remove, &QPushButton::clicked, this, [this] {
        TracingImage tracing = m_settings.values().tracing;
        tracing.image = {};
        m_settings.set(&SceneLook::tracing, tracing);
    });
    m_tracingName = new QLabel(parent);
    m_tracingName->setTextFormat(Qt::PlainText);
    file->addWidget(m_tracingName);
    file->addStretch();
    auto* place = new QVBoxLayout;
    place->setSpacing(2);
    line->addLayout(place);
    for (const FieldPlace field : {OpacityField, HeightField, RightField, UpField}) {
        addRow(*place, field);
        m_rows[field]->setFixedWidth(kPlaceWidth);
    }
    place->addStretch();
    column.addStretch();
}

ViewRow* BackgroundPanel::row(const char* key) const
{
    const auto found =
        std::ranges::find_if(m_rows, [&](const ViewRow* row) { return std::strcmp(row->key(), key) == 0; });
    return found == m_rows.end() ? nullptr : *found;
}

void BackgroundPanel::askForColour(QColor ViewValues::*colour)
{
    auto* dialog = new QColorDialog(m_settings.values().*colour, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const QColor before = dialog->currentColor();
    connect(dialog, &QColorDialog::currentColorChanged, this,
            [this, colour](const QColor& picked) { m_settings.set(colour, picked); });
    connect(dialog, &QDialog::rejected, this, [this, colour, before] { m_settings.set(colour, before); });
    dialog->open();
}

void BackgroundPanel::setLookOfNewTrees(const SceneLook& look)
{
    m_newLook = look;
    showValues();
}

void BackgroundPanel::showValues()
{
    const ViewValues& values = m_settings.values();
    const bool isGradient = values.backdrop == Backdrop::Gradient;
    m_colour->setText(isGradient ? tr("Lower colour") : tr("Colour"));
    m_colour->setIcon(swatch(values.backgroundColour));
    m_colour->setEnabled(isGradient || values.backdrop == Backdrop::Plain);
    m_topColour->setText(tr("Upper colour"));
    m_topColour->setIcon(swatch(values.backgroundTop));
    m_topColour->setEnabled(isGradient);

    m_useForNew->setEnabled(withoutPicture(values) != withoutPicture(m_newLook));

    const ImageAsset& image = values.tracing.image;
    m_remove->setEnabled(!image.isNull());
    for (const FieldPlace field : {OpacityField, HeightField, RightField, UpField})
        m_rows[field]->setEnabled(!image.isNull());
    m_tracingName->setText(
        m_tracingName->fontMetrics().elidedText(image.name(), Qt::ElideMiddle, kTracingWidth));
    m_tracingName->setToolTip(image.name());
}

} // namespace espalier
