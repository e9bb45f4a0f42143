// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/SettingsSheet.h"

#include "panels/Bar.h"
#include "panels/FineSlider.h"
#include "panels/PressureCurve.h"
#include "panels/Theme.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kSheetSteps = 100; ///< Of the slider, to either side
constexpr int kColumn = 300;
constexpr int kLabel = 148;
constexpr int kControl = theme::kTarget;
constexpr double kHundredths = 100.0; ///< Of a second

/// The slider is logarithmic: its middle is a straight line.
int sliderOf(double exponent)
{
    return static_cast<int>(std::lround(kSheetSteps * std::log(exponent) / std::log(Preferences::kFirmest)));
}

double exponentOf(int slider)
{
    return std::pow(Preferences::kFirmest, static_cast<double>(slider) / kSheetSteps);
}

QString mouseNote(MouseScheme scheme)
{
    switch (scheme) {
    case MouseScheme::Blender:
        return SettingsSheet::tr("The middle button turns; with Shift it pans, with Ctrl it zooms. Alt with "
                                 "the left button turns, too.");
    case MouseScheme::Maya:
        return SettingsSheet::tr(
            "With Alt, the left button turns, the middle one pans and the right one zooms.");
    case MouseScheme::Espalier:
        break;
    }
    return SettingsSheet::tr("The right or middle button turns; Shift with the middle button pans. Alt with "
                             "the left button turns, too.");
}

} // namespace

SettingsSheet::SettingsSheet(const Preferences& preferences, QWidget* parent)
    : QDialog(parent),
      m_look(new QComboBox(this)),
      m_side(new QComboBox(this)),
      m_language(new QComboBox(this)),
      m_units(new QComboBox(this)),
      m_scale(new QComboBox(this)),
      m_curve(new PressureCurve(Preferences::kSoftest, Preferences::kFirmest, this)),
      m_softness(new FineSlider(this)),
      m_distance(new FineSlider(this)),
      m_delay(new FineSlider(this)),
      m_distanceText(new QLabel(this)),
      m_delayText(new QLabel(this)),
      m_mouse(new QComboBox(this)),
      m_mouseNote(makeNote()),
      m_undo(new QSpinBox(this)),
      m_undoMemory(new QSpinBox(this)),
      m_folder(makeNote()),
      m_defaults(new QPushButton(tr("Defaults"), this))
{
    setWindowTitle(tr("Settings"));
    auto* left = new QVBoxLayout;
    left->setSpacing(8);
    left->addLayout(makeAppearance());
    left->addSpacing(14);
    left->addLayout(makeWork());
    left->addStretch(1);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(34);
    columns->addLayout(left);
    columns->addLayout(makeHand());
    auto* close = new QPushButton(tr("Close"), this);
    close->setDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_defaults);
    buttons->addStretch(1);
    buttons->addWidget(close);
    for (QPushButton* button : {m_defaults, close})
        button->setMinimumSize(110, theme::kTarget);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(26, 20, 26, 20);
    all->setSpacing(18);
    all->addLayout(columns);
    all->addLayout(buttons);
    all->setSizeConstraint(QLayout::SetFixedSize);

    m_scale->setMinimumHeight(kControl);
    connect(m_scale, &QComboBox::activated, this,
            [this] { Q_EMIT interfaceScaleEdited(m_scale->currentData().toInt()); });
    for (QComboBox* box : {m_look, m_side, m_language, m_units, m_mouse}) {
        box->setMinimumHeight(kControl);
        connect(box, &QComboBox::currentIndexChanged, this, &SettingsSheet::edit);
    }
    for (QSpinBox* number : {m_undo, m_undoMemory}) {
        number->setMinimumHeight(kControl);
        number->setButtonSymbols(QAbstractSpinBox::NoButtons);
        // Not while a number is being typed: 1 on the way to 1000 would drop most of the history.
        number->setKeyboardTracking(false);
        connect(number, &QSpinBox::valueChanged, this, &SettingsSheet::edit);
    }
    connect(m_softness, &QSlider::valueChanged, this, [this](int value) {
        if (m_isShowing)
            return;
        m_curve->setExponent(exponentOf(value));
        edit();
    });
    connect(m_curve, &PressureCurve::exponentEdited, this, [this] { edit(); });
    for (QSlider* slider : {m_distance, m_delay})
        connect(slider, &QSlider::valueChanged, this, &SettingsSheet::edit);
    connect(m_defaults, &QPushButton::clicked, this, [this] {
        take({});
        setInterfaceScale(scales().constFirst());
        Q_EMIT interfaceScaleEdited(scales().constFirst());
    });
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    setPreferences(preferences);
}

QLabel* SettingsSheet::makeNote(const QString& text)
{
    auto* note = new QLabel(text, this);
    note->setTextFormat(Qt::PlainText);
    note->setWordWrap(true);
    note->setFixedWidth(kColumn);
    theme::setTone(*note, theme::Tone::Dim);
    return note;
}

QLabel* SettingsSheet::makeLabel(const QString& text, QWidget* buddy)
{
    auto* label = new QLabel(text, this);
    label->setFixedSize(kLabel, kControl);
    label->setBuddy(buddy);
    return label;
}

QLayout* SettingsSheet::makeAppearance()
{
    m_look->addItems({tr("Dark"), tr("Light"), tr("Like the system")});
    m_look->setObjectName(QStringLiteral("look"));
    m_side->addItems({tr("On the left"), tr("On the right")});
    m_side->setObjectName(QStringLiteral("side"));
    auto* form = new QFormLayout;
    form->setVerticalSpacing(8);
    form->setHorizontalSpacing(18);
    form->addRow(barHeading(tr("Appearance"), this));
    form->addRow(makeLabel(tr("Theme"), m_look), m_look);
    form->addRow(makeLabel(tr("Tools"), m_side), m_side);
    m_language->setObjectName(QStringLiteral("language"));
    m_language->addItem(tr("Like the system"));
    for (const QString& code : Preferences::languages()) {
        const QLocale locale(code);
        m_language->addItem(locale.nativeLanguageName(), code);
    }
    form->addRow(makeLabel(tr("Language"), m_language), m_language);
    m_units->addItems({tr("Metres, centimetres"), tr("Feet, inches")});
    m_units->setObjectName(QStringLiteral("units"));
    form->addRow(makeLabel(tr("Lengths"), m_units), m_units);
    for (const int percent : scales())
        m_scale->addItem(tr("%L1 %").arg(percent), percent);
    m_scale->setObjectName(QStringLiteral("scale"));
    m_scale->setToolTip(tr("Takes effect the next time Espalier starts."));
    form->addRow(makeLabel(tr("Size of the interface"), m_scale), m_scale);
    return form;
}

QLayout* SettingsSheet::makeHand()
{
    m_softness->setRange(-kSheetSteps, kSheetSteps);
    m_softness->setMinimumHeight(kControl);
    m_softness->setObjectName(QStringLiteral("softness"));
    m_softness->setAccessibleName(tr("Pressure"));
    m_softness->setToolTip(tr("How firmly a pen must press for a large brush."));
    m_curve->setToolTip(tr("Press here with your pen to try it."));
    m_mouse->addItems({QStringLiteral("Espalier"), QStringLiteral("Blender"), QStringLiteral("Maya")});
    m_mouse->setObjectName(QStringLiteral("mouse"));
    m_mouse->setAccessibleName(tr("Mouse"));
    m_mouseNote->setMinimumHeight(3 * m_mouseNote->fontMetrics().lineSpacing());
    m_mouseNote->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* scale = new QHBoxLayout;
    scale->addWidget(new QLabel(tr("Soft"), this));
    scale->addWidget(m_softness, 1);
    scale->addWidget(new QLabel(tr("Firm"), this));
    auto* column = new QVBoxLayout;
    column->setSpacing(8);
    column->addWidget(barHeading(tr("Pen pressure"), this));
    column->addWidget(m_curve);
    column->addLayout(scale);
    column->addSpacing(14);
    column->addWidget(barHeading(tr("Stroke stabiliser"), this));
    column->addLayout(makeStabiliser());
    column->addSpacing(14);
    column->addWidget(barHeading(tr("Mouse"), this));
    column->addWidget(m_mouse);
    column->addWidget(m_mouseNote);
    column->addStretch(1);
    return column;
}

QLayout* SettingsSheet::makeStabiliser()
{
    m_distance->setRange(0, qRound(Stabilising::kGreatestDistance));
    m_distance->setObjectName(QStringLiteral("stabiliserDistance"));
    m_distance->setToolTip(tr(
        "A stroke follows the pointer at this distance, like a stone on a string, so it does not tremble."));
    m_delay->setRange(0, qRound(kHundredths * Stabilising::kLongestDelay));
    m_delay->setObjectName(QStringLiteral("stabiliserDelay"));
    m_delay->setToolTip(tr("A stroke lags this far behind the pointer, and is smoother."));
    m_distance->setAccessibleName(tr("Distance"));
    m_delay->setAccessibleName(tr("Delay"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(18);
    grid->addWidget(makeLabel(tr("Distance"), m_distance), 0, 0);
    grid->addWidget(m_distance, 0, 1);
    grid->addWidget(m_distanceText, 0, 2);
    grid->addWidget(makeLabel(tr("Delay"), m_delay), 1, 0);
    grid->addWidget(m_delay, 1, 1);
    grid->addWidget(m_delayText, 1, 2);
    for (QSlider* slider : {m_distance, m_delay})
        slider->setMinimumHeight(kControl);
    for (QLabel* text : {m_distanceText, m_delayText})
        text->setMinimumWidth(text->fontMetrics().horizontalAdvance(tr("%1 s").arg(0.25)));
    return grid;
}

QLayout* SettingsSheet::makeWork()
{
    m_undo->setRange(0, Preferences::kMostUndoSteps);
    m_undo->setSpecialValueText(tr("all"));
    m_undo->setObjectName(QStringLiteral("undo"));
    m_undoMemory->setRange(Preferences::kLeastUndoMemory, Preferences::kMostUndoMemory);
    m_undoMemory->setSuffix(tr(" MB"));
    m_undoMemory->setObjectName(QStringLiteral("undoMemory"));
    auto* change = new QPushButton(tr("Change…"), this);
    change->setMinimumHeight(kControl);
    connect(change, &QPushButton::clicked, this, &SettingsSheet::chooseFolder);
    auto* form = new QFormLayout;
    form->setVerticalSpacing(8);
    form->setHorizontalSpacing(18);
    form->addRow(barHeading(tr("Work"), this));
    form->addRow(makeLabel(tr("Undo steps kept"), m_undo), m_undo);
    form->addRow(makeNote(tr("A change applies to the next tree that you begin or open.")));
    form->addRow(makeLabel(tr("Memory for undo"), m_undoMemory), m_undoMemory);
    form->addRow(makeNote(tr("If the history takes more, its oldest steps go.")));
    form->addRow(makeLabel(tr("Library"), change), change);
    form->addRow(m_folder);
    return form;
}

void SettingsSheet::setPreferences(const Preferences& preferences)
{
    m_preferences = preferences;
    display(preferences);
}

void SettingsSheet::setInterfaceScale(int percent)
{
    m_scale->setCurrentIndex(m_scale->findData(percent));
}

void SettingsSheet::display(const Preferences& preferences)
{
    m_isShowing = true;
    m_look->setCurrentIndex(static_cast<int>(preferences.look));
    m_side->setCurrentIndex(preferences.areToolsRight ? 1 : 0);
    m_language->setCurrentIndex(std::max(0, m_language->findData(preferences.language)));
    m_units->setCurrentIndex(static_cast<int>(preferences.units));
    m_curve->setExponent(preferences.pressureExponent);
    m_softness->setValue(sliderOf(preferences.pressureExponent));
    const Stabilising& stabilising = preferences.stabilising;
    m_distance->setValue(qRound(stabilising.distance));
    m_distanceText->setText(stabilising.distance > 0.0 ? tr("%1 px").arg(m_distance->value()) : tr("off"));
    m_delay->setValue(qRound(kHundredths * stabilising.delay));
    m_delayText->setText(
        stabilising.delay > 0.0 ? tr("%1 s").arg(locale().toString(stabilising.delay, 'f', 2)) : tr("off"));
    m_mouse->setCurrentIndex(static_cast<int>(preferences.mouse));
    m_mouseNote->setText(mouseNote(preferences.mouse));
    m_undo->setValue(preferences.undoSteps);
    m_undoMemory->setValue(preferences.undoMemory);
    const QString folder = QDir::toNativeSeparators(preferences.libraryFolder);
    m_folder->setText(folder.isEmpty()
                          ? tr("In Espalier's own folder")
                          : m_folder->fontMetrics().elidedText(folder, Qt::ElideMiddle, kColumn));
    m_folder->setToolTip(folder);
    m_isShowing = false;
}

void SettingsSheet::edit()
{
    if (m_isShowing)
        return;
    Preferences edited = m_preferences;
    edited.look = static_cast<Look>(m_look->currentIndex());
    edited.areToolsRight = m_side->currentIndex() == 1;
    edited.language = m_language->currentData().toString();
    edited.units = static_cast<Units>(m_units->currentIndex());
    edited.pressureExponent = m_curve->exponent();
    edited.stabilising = {.distance = static_cast<double>(m_distance->value()),
                          .delay = m_delay->value() / kHundredths};
    edited.mouse = static_cast<MouseScheme>(m_mouse->currentIndex());
    edited.undoSteps = m_undo->value();
    edited.undoMemory = m_undoMemory->value();
    take(edited);
}

void SettingsSheet::take(const Preferences& preferences)
{
    if (preferences == m_preferences)
        return;
    m_preferences = preferences;
    display(preferences);
    Q_EMIT preferencesEdited(preferences);
}

void SettingsSheet::chooseFolder()
{
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Library Folder"), m_preferences.libraryFolder);
    if (folder.isEmpty())
        return;
    Preferences edited = m_preferences;
    edited.libraryFolder = folder;
    take(edited);
}

} // namespace espalier
