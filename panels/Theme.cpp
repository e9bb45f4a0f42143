// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QPixmapCache>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleFactory>
#include <QWidget>

#include <algorithm>

namespace espalier::theme {

namespace {

/// Fusion, but a press on a slider's track moves the handle there.
class Style : public QProxyStyle {
public:
    Style() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* result) const override
    {
        if (hint == SH_Slider_AbsoluteSetButtons)
            return Qt::LeftButton;
        if (hint == SH_ToolTip_WakeUpDelay)
            return 450;
        if (hint == SH_ComboBox_Popup)
            return 0; // A list below the box, whose entries can be large enough for a finger
        return QProxyStyle::styleHint(hint, option, widget, result);
    }

    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                           const QWidget* widget) const override
    {
        QSize wanted = QProxyStyle::sizeFromContents(type, option, size, widget);
        if (type == CT_ItemViewItem && widget && widget->window()->windowType() == Qt::Popup)
            wanted.setHeight(std::max(wanted.height(), kTarget));
        return wanted;
    }
};

constexpr Colours kLight{
    .workspace = {0xf2, 0xf3, 0xf1},
    .bar = {0xfb, 0xfb, 0xfa, 0xf2},
    .raised = {0xff, 0xff, 0xff},
    .edge = {0xcd, 0xd1, 0xd0},
    .sunken = {0xe2, 0xe5, 0xe3},
    .text = {0x25, 0x2a, 0x2f},
    .brightText = {0x0b, 0x0e, 0x10},
    .dimText = {0x58, 0x60, 0x68},
    .faintText = {0xa0, 0xa7, 0xad},
    .accent = {0x4c, 0x86, 0x3a},
    .accentFill = {0xd3, 0xe6, 0xcb},
    .accentText = {0x2f, 0x66, 0x20},
    .handle = {0xbd, 0x68, 0x0e},
    .handleFill = {0xec, 0xc3, 0x8e},
    .keyCap = {0xf1, 0xec, 0xe2},
    .warning = {0xb8, 0x3f, 0x2c},
    .knob = {0xff, 0xff, 0xff},
    .button = {0xe3, 0xe6, 0xe4},
    .buttonHover = {0xd6, 0xda, 0xd7},
    .buttonDisabled = {0xec, 0xee, 0xec},
    .hover = {0x00, 0x00, 0x00, 14},
    .pressed = {0x00, 0x00, 0x00, 30},
    .highlight = {0xb9, 0xd8, 0xab},
};

/// Whether the system's own colours are light; call it before this program sets its colours.
bool isSystemLight()
{
    static const bool kIsLight = QGuiApplication::palette().color(QPalette::Window).lightness() > 127;
    return kIsLight;
}

QPalette palette()
{
    QPalette colours(kText, inForce.button, kEdge, kSunken, inForce.button, kText, kBrightText, kSunken,
                     kRaised);
    colours.setColor(QPalette::AlternateBase, kRaised);
    colours.setColor(QPalette::Highlight, inForce.highlight);
    colours.setColor(QPalette::HighlightedText, kBrightText);
    colours.setColor(QPalette::Link, kAccent);
    colours.setColor(QPalette::LinkVisited, kAccent);
    colours.setColor(QPalette::PlaceholderText, kFaintText);
    colours.setColor(QPalette::ToolTipBase, kBubble);
    colours.setColor(QPalette::ToolTipText, kBubbleText);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        colours.setColor(QPalette::Disabled, role, kFaintText);
    return colours;
}

QString toCss(const QColor& colour)
{
    return QStringLiteral("rgba(%1, %2, %3, %4)")
        .arg(colour.red())
        .arg(colour.green())
        .arg(colour.blue())
        .arg(colour.alpha());
}

} // namespace

bool isLight()
{
    return kWorkspace.lightness() > 127;
}

void setTone(QWidget& label, Tone tone)
{
    const char* const names[] = {"dim", "bright", "overDark", "overLight"};
    const QString name = QString::fromLatin1(names[static_cast<int>(tone)]);
    if (label.property("tone") == name)
        return;
    label.setProperty("tone", name);
    // A style sheet only sees a changed property after this.
    label.style()->polish(&label);
}

void apply(QApplication& application, Look look)
{
    const bool isLight = look == Look::Light || (isSystemLight() && look == Look::System);
    inForce = isLight ? kLight : Colours();
    QPixmapCache::clear(); // Cached icons have the old colours
    if (!dynamic_cast<Style*>(QApplication::style()))
        application.setStyle(new Style);
    QApplication::setPalette(palette());

    QString sheet = QStringLiteral(R"(
        QToolTip { color: @bubbleText; background: @bubble; border: 1px solid @bubbleEdge; padding: 5px 7px; }
        QMenu { background: @raised; color: @text; border: 1px solid @edge; padding: 5px; }
        QMenu::item { padding: 15px 28px 15px 12px; border-radius: 5px; }
        QMenu::item:selected { background: @accentFill; color: @bright; }
        QMenu::item:disabled { color: @faint; }
        QMenu::separator { height: 1px; background: @edge; margin: 5px 8px; }
        QMenu::icon { padding-left: 8px; }

        espalier--BarButton { border: none; border-radius: 8px; background: transparent; color: @dim; padding: 0; }
        espalier--BarButton:hover { background: @hover; color: @text; }
        espalier--BarButton:pressed { background: @pressed; }
        espalier--BarButton:checked { background: @accentFill; color: @bright; }
        espalier--BarButton:disabled { color: @faint; background: transparent; }
        espalier--BarButton:focus { border: 1px solid @accent; }
        espalier--BarButton::menu-indicator { image: none; }
        espalier--BarButton[look="icon"]:checked { background: transparent; }
        espalier--BarButton[look="icon"]:checked:hover { background: @hover; }
        espalier--BarButton[look="tool"] { padding-top: 5px; padding-bottom: 3px; }
        espalier--BarButton[look="tab"] { padding: 0 11px; }
        espalier--BarButton[look="tab"]:checked { background: @sunken; color: @bright; font-weight: bold; }

        QPushButton { background: @button; color: @text; border: 1px solid transparent; border-radius: 8px; padding: 6px 16px; }
        QPushButton:hover { background: @buttonHover; color: @bright; }
        QPushButton:pressed { background: @accentFill; }
        QPushButton:checked { background: @accentFill; color: @bright; }
        QPushButton:default { background: #4c7a3e; color: white; }
        QPushButton:default:hover { background: #588a49; color: white; }
        QPushButton:disabled { background: @buttonDisabled; color: @faint; }
        QPushButton:focus { border-color: @accent; }
        QComboBox { background: @sunken; color: @text; border: 1px solid @edge; border-radius: 6px; padding: 4px 8px; margin: 4px 0; }
        QComboBox:hover { border-color: @faint; }
        QComboBox:disabled { color: @text; }
        QComboBox:focus { border-color: @accent; }
        QComboBox::drop-down { border: none; width: 20px; }
        QComboBox::down-arrow { image: url(:/icons/chevron.svg); width: 12px; height: 12px; }
        QComboBox QAbstractItemView { background: @raised; color: @text; border: 1px solid @edge; selection-background-color: @accentFill; selection-color: @bright; }
        espalier--LabelEditor { background: @raised; color: @bright; border: 1px solid @accent; border-radius: 5px; padding: 0 5px; }
        espalier--HelpPanel QLineEdit { background: @sunken; border: 1px solid @edge; border-radius: 8px; padding: 4px 8px; }
        espalier--HelpPanel QLineEdit:focus { border-color: @accent; }
        espalier--HelpPanel QTextBrowser { background: transparent; }
        espalier--HelpPanel QListWidget { background: transparent; outline: none; }
        espalier--HelpPanel QListWidget::item { padding-left: 10px; border: 1px solid transparent; border-radius: 8px; color: @text; }
        espalier--HelpPanel QListWidget::item:selected { background: @accentFill; color: @bright; }
        espalier--HelpPanel QListWidget::item:disabled { color: @dim; }
        espalier--HelpPanel QListWidget:focus::item:selected { border-color: @accent; }
        QSpinBox { background: @sunken; border: 1px solid @edge; border-radius: 6px; padding: 2px 8px; margin: 4px 0; }
        QSpinBox:focus { border-color: @accent; }
        QProgressBar { background: @sunken; border: none; border-radius: 4px; }
        QProgressBar::chunk { background: @accent; border-radius: 4px; }

        QSlider { background: transparent; }
        QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @sunken; }
        QSlider::sub-page:horizontal { height: 4px; border-radius: 2px; background: @accent; }
        QSlider::handle:horizontal { width: 14px; height: 14px; margin: -5px 0; border-radius: 7px; background: @knob; border: 1px solid @edge; }
        QSlider::handle:horizontal:hover { background: @knobHover; }
        QSlider::handle:horizontal:focus { background: @knobHover; border: 2px solid @accent; margin: -7px -2px; border-radius: 9px; }

        QDoubleSpinBox[bare="true"] { background: transparent; border: none; padding: 0; color: @text; }
        QDoubleSpinBox[bare="true"]:focus { background: @sunken; border-radius: 3px; }
        QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }
        QScrollBar:horizontal { height: 8px; background: transparent; }
        QScrollBar:vertical { width: 8px; background: transparent; }
        QScrollBar::handle:horizontal { background: @edge; border-radius: 4px; min-width: 40px; }
        QScrollBar::handle:vertical { background: @edge; border-radius: 4px; min-height: 40px; }
        QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
        QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

        QFrame[separator="true"] { background: @edge; }
        QLabel[picture="true"] { background: @sunken; color: @dim; border-radius: 8px; }
        QLabel[tone="dim"] { color: @dim; }
        QLabel[tone="bright"] { color: @text; }
        QLabel[tone="overDark"] { color: @overDark; }
        QLabel[tone="overLight"] { color: @overLight; }
        QLabel[overPicture="true"] { padding: 3px 9px; border-radius: 9px; }
        QLabel[overPicture="true"][tone="overDark"] { color: @bubbleText; background: @veilDark; }
        QLabel[overPicture="true"][tone="overLight"] { color: @bubble; background: @veilLight; }
        espalier--LibraryPanel QLineEdit { background: @sunken; border: 1px solid @edge; border-radius: 8px; padding: 4px 8px; }
        espalier--LibraryPanel QLineEdit:focus { border-color: @accent; }
        espalier--CardView { background: transparent; outline: none; }
        QLineEdit { background: @sunken; border: 1px solid @edge; border-radius: 6px; padding: 2px 6px; }
    )");
    // If one name begins with another, the longer one comes first.
    const std::pair<const char*, QColor> names[] = {
        {"@accentFill", kAccentFill},
        {"@accent", kAccent},
        {"@bright", kBrightText},
        {"@bubbleEdge", kBubbleEdge},
        {"@bubbleText", kBubbleText},
        {"@bubble", kBubble},
        {"@buttonDisabled", inForce.buttonDisabled},
        {"@buttonHover", inForce.buttonHover},
        {"@button", inForce.button},
        {"@dim", kDimText},
        {"@edge", kEdge},
        {"@faint", kFaintText},
        {"@hover", inForce.hover},
        {"@knobHover", Qt::white},
        {"@knob", inForce.knob},
        {"@overDark", kOverDark},
        {"@overLight", kOverLight},
        {"@pressed", inForce.pressed},
        {"@raised", kRaised},
        {"@sunken", kSunken},
        {"@text", kText},
        {"@veilDark", QColor(0x16, 0x18, 0x1c, 0x96)},
        {"@veilLight", QColor(0xff, 0xff, 0xff, 0xb4)},
    };
    for (const auto& [name, colour] : names)
        sheet.replace(QLatin1String(name), toCss(colour));
    application.setStyleSheet(sheet);
}

} // namespace espalier::theme
