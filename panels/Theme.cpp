// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>

namespace espalier::theme {

namespace {

/// Fusion, but a press on a slider's track takes the handle there, as a finger expects.
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
        return QProxyStyle::styleHint(hint, option, widget, result);
    }
};

QPalette palette()
{
    QPalette colours(kText, QColor(0x33, 0x39, 0x43), kEdge, kSunken, QColor(0x2d, 0x32, 0x3b), kText,
                     Qt::white, kSunken, QColor(0x2b, 0x30, 0x39));
    colours.setColor(QPalette::AlternateBase, QColor(0x24, 0x28, 0x2f));
    colours.setColor(QPalette::Highlight, QColor(0x4f, 0x70, 0x46));
    colours.setColor(QPalette::HighlightedText, Qt::white);
    colours.setColor(QPalette::Link, kAccent);
    colours.setColor(QPalette::LinkVisited, kAccent);
    colours.setColor(QPalette::PlaceholderText, kFaintText);
    colours.setColor(QPalette::ToolTipBase, QColor(0x16, 0x18, 0x1c));
    colours.setColor(QPalette::ToolTipText, kText);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        colours.setColor(QPalette::Disabled, role, kFaintText);
    return colours;
}

} // namespace

void apply(QApplication& application)
{
    application.setStyle(new Style);
    QApplication::setPalette(palette());

    QString sheet = QStringLiteral(R"(
        QToolTip { color: @text; background: #16181c; border: 1px solid @edge; padding: 5px 7px; }
        QMenu { background: #2b3039; border: 1px solid @edge; padding: 5px; }
        QMenu::item { padding: 8px 28px 8px 12px; border-radius: 5px; }
        QMenu::item:selected { background: @accentFill; }
        QMenu::item:disabled { color: @faint; }
        QMenu::separator { height: 1px; background: @edge; margin: 5px 8px; }
        QMenu::icon { padding-left: 8px; }

        espalier--BarButton { border: none; border-radius: 8px; background: transparent; color: @dim; padding: 0; }
        espalier--BarButton:hover { background: rgba(255, 255, 255, 16); color: @text; }
        espalier--BarButton:pressed { background: rgba(255, 255, 255, 34); }
        espalier--BarButton:checked { background: @accentFill; color: white; }
        espalier--BarButton:disabled { color: @faint; background: transparent; }
        espalier--BarButton:focus { border: 1px solid @accent; }
        espalier--BarButton::menu-indicator { image: none; }
        espalier--BarButton[look="icon"]:checked { background: transparent; }
        espalier--BarButton[look="icon"]:checked:hover { background: rgba(255, 255, 255, 16); }
        espalier--BarButton[look="tool"] { padding-top: 5px; padding-bottom: 3px; }
        espalier--BarButton[look="tab"] { padding: 0 15px; }
        espalier--BarButton[look="tab"]:checked { background: @sunken; color: white; font-weight: bold; }

        QPushButton { background: #3a424e; color: @text; border: 1px solid transparent; border-radius: 8px; padding: 6px 16px; }
        QPushButton:hover { background: #454e5c; color: white; }
        QPushButton:pressed { background: @accentFill; }
        QPushButton:default { background: #4c6a44; color: white; }
        QPushButton:default:hover { background: #587b4f; }
        QPushButton:disabled { background: #2f353e; color: @faint; }
        QPushButton:focus { border-color: @accent; }
        QComboBox { background: @sunken; border: 1px solid @edge; border-radius: 6px; padding: 4px 8px; }
        QComboBox:hover { border-color: @faint; }
        QComboBox:disabled { color: @text; }
        QComboBox:focus { border-color: @accent; }
        QComboBox::drop-down { border: none; width: 20px; }
        QComboBox::down-arrow { image: url(:/icons/chevron.svg); width: 12px; height: 12px; }
        QComboBox QAbstractItemView { background: #2b3039; border: 1px solid @edge; selection-background-color: @accentFill; }
        espalier--HelpPanel QLineEdit { background: @sunken; border: 1px solid @edge; border-radius: 8px; padding: 4px 8px; }
        espalier--HelpPanel QLineEdit:focus { border-color: @accent; }
        espalier--HelpPanel QTextBrowser { background: transparent; }
        espalier--HelpPanel QListWidget { background: transparent; outline: none; }
        espalier--HelpPanel QListWidget::item { padding-left: 10px; border: 1px solid transparent; border-radius: 8px; color: @text; }
        espalier--HelpPanel QListWidget::item:selected { background: @accentFill; color: white; }
        espalier--HelpPanel QListWidget::item:disabled { color: @dim; }
        espalier--HelpPanel QListWidget:focus::item:selected { border-color: @accent; }
        QSpinBox { background: @sunken; border: 1px solid @edge; border-radius: 6px; padding: 2px 8px; }
        QSpinBox:focus { border-color: @accent; }
        QProgressBar { background: @sunken; border: none; border-radius: 4px; }
        QProgressBar::chunk { background: @accent; border-radius: 4px; }

        QSlider { background: transparent; }
        QSlider::groove:horizontal { height: 4px; border-radius: 2px; background: @sunken; }
        QSlider::sub-page:horizontal { height: 4px; border-radius: 2px; background: @accent; }
        QSlider::handle:horizontal { width: 14px; height: 14px; margin: -5px 0; border-radius: 7px; background: #d5dbe4; }
        QSlider::handle:horizontal:hover { background: white; }
        QSlider::handle:horizontal:focus { background: white; border: 2px solid @accent; margin: -7px -2px; border-radius: 9px; }

        QDoubleSpinBox[bare="true"] { background: transparent; border: none; padding: 0; color: @text; }
        QDoubleSpinBox[bare="true"]:focus { background: @sunken; border-radius: 3px; }
        QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; }
        QScrollBar:horizontal { height: 8px; background: transparent; }
        QScrollBar:vertical { width: 8px; background: transparent; }
        QScrollBar::handle:horizontal { background: @edge; border-radius: 4px; min-width: 40px; }
        QScrollBar::handle:vertical { background: @edge; border-radius: 4px; min-height: 40px; }
        QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
        QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
    )");
    const auto put = [&](const char* name, const QColor& colour) {
        sheet.replace(QLatin1String(name), colour.name());
    };
    put("@accentFill", kAccentFill);
    put("@accent", kAccent);
    put("@dim", kDimText);
    put("@edge", kEdge);
    put("@faint", kFaintText);
    put("@sunken", kSunken);
    put("@text", kText);
    application.setStyleSheet(sheet);
}

} // namespace espalier::theme
