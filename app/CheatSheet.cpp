// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/CheatSheet.h"

#include "app/Actions.h"
#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>

namespace espalier {

namespace {

struct Line {
    QString what;
    QStringList keys;
};

QString keyCap(const QString& key)
{
    return QStringLiteral("<span style='background:%1; color:%2'>&nbsp;%3&nbsp;</span>")
        .arg(theme::kSunken.name(), theme::kHandle.name(), key.toHtmlEscaped());
}

QString section(const QString& title, const QList<Line>& lines)
{
    QString html =
        QStringLiteral("<h3 style='margin-bottom:4px'>%1</h3><table cellspacing='0' cellpadding='5'>")
            .arg(title.toHtmlEscaped());
    for (const Line& line : lines) {
        QStringList caps;
        for (const QString& key : line.keys)
            caps.append(keyCap(key));
        html += QStringLiteral("<tr><td style='padding-right:14px'>%1</td><td>%2</td></tr>")
                    .arg(line.what.toHtmlEscaped(), caps.join(QStringLiteral(" &nbsp;")));
    }
    return html + QStringLiteral("</table>");
}

QString actionSection(ActionGroup group)
{
    QList<Line> lines;
    for (const ActionEntry& entry : Actions::table()) {
        if (entry.group != group || *entry.shortcuts == '\0')
            continue;
        Line line{QCoreApplication::translate("Actions", entry.text), {}};
        line.what.remove(QChar(0x2026));
        for (const QKeySequence& key : QKeySequence::listFromString(QString::fromLatin1(entry.shortcuts)))
            line.keys.append(key.toString(QKeySequence::NativeText));
        lines.append(line);
    }
    return section(Actions::groupTitle(group), lines);
}

} // namespace

CheatSheet::CheatSheet(QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Keys and Gestures"));
    const QList<Line> mouse{
        {tr("Use the tool"), {tr("left button")}},
        {tr("Turn"), {tr("right button"), tr("Alt + left")}},
        {tr("Move"), {tr("Shift + middle"), tr("Space + left")}},
        {tr("Nearer, farther"), {tr("wheel")}},
        {tr("Brush size"), {tr("Ctrl + wheel")}},
        {tr("One bud alone grows"), {tr("Alt + click")}},
        {tr("Light"), {tr("drag the sun")}},
    };
    const QList<Line> touch{
        {tr("Use the tool"), {tr("one finger"), tr("pen")}},
        {tr("Move, nearer, farther"), {tr("two fingers")}},
        {tr("Turn"), {tr("three fingers"), tr("bottom edge")}},
        {tr("Brush size"), {tr("pen pressure")}},
        {tr("Prune"), {tr("pen's eraser")}},
        {tr("Bend"), {tr("one to three fingers on a branch")}},
    };
    const QList<Line> keys{
        {tr("Turn"), {tr("arrows"), QStringLiteral("Q"), QStringLiteral("E")}},
        {tr("Move"), {tr("Shift + arrows")}},
        {tr("Nearer, farther"), {QStringLiteral("+"), QStringLiteral("-")}},
    };
    const QList<Line> controls{
        {tr("From one to the next"), {QStringLiteral("Tab")}},
        {tr("Change"), {tr("drag"), tr("arrows"), tr("type")}},
        {tr("Finely, coarsely"), {tr("Shift + arrows"), tr("Page up, down")}},
        {tr("Back to the default"), {tr("double click"), QStringLiteral("Del")}},
        {tr("Take a drag back"), {QStringLiteral("Esc")}},
    };
    const QStringList columns{
        actionSection(ActionGroup::Tools) + actionSection(ActionGroup::Edit),
        actionSection(ActionGroup::View) + section(tr("Camera, while brushing too"), keys) +
            section(tr("Sliders and handles"), controls),
        section(tr("Mouse"), mouse) + section(tr("Touch and pen"), touch),
        actionSection(ActionGroup::File) + actionSection(ActionGroup::Window),
    };
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(26, 14, 26, 22);
    row->setSpacing(34);
    for (const QString& html : columns) {
        auto* label = new QLabel(html, this);
        label->setTextFormat(Qt::RichText);
        label->setAlignment(Qt::AlignTop);
        row->addWidget(label);
    }
}

} // namespace espalier
