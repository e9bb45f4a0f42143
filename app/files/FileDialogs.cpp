// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileDialogs.h"

#include "model/io/export/ExportFormats.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace espalier::dialogs {

namespace {

struct DialogText {
    Q_DECLARE_TR_FUNCTIONS(FileDialogs)
};

/// Gives a button a text with a key of its own, in place of the style's text and icon.
void dress(QAbstractButton& button, const QString& text)
{
    button.setText(text);
    button.setIcon(QIcon());
}

/// The name of the file to be written, suggested from @p start; empty if the user cancels.
QString askForNew(QFileDialog& dialog, const QString& start)
{
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.selectFile(QFileInfo(start).completeBaseName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

} // namespace

QString suffixOf(const QString& fileName)
{
    return QFileInfo(fileName).suffix().toLower();
}

QString askForOpening(QWidget& window, const Settings& settings)
{
    return QFileDialog::getOpenFileName(
        &window, DialogText::tr("Open"), settings.folder(),
        DialogText::tr("Trees, recipes and measured skeletons (*.espalier *.json *.csv);;Trees (*.espalier);;"
                       "Recipes (*.json);;Skeletons (*.csv);;All files (*)"));
}

QString askForSaving(QWidget& window, const QString& start)
{
    QFileDialog dialog(&window, DialogText::tr("Save"), QFileInfo(start).path(),
                       DialogText::tr("Trees (*.espalier)"));
    dialog.setDefaultSuffix(kProjectSuffix);
    return askForNew(dialog, start);
}

QString askForRecipe(QWidget& window, const QString& start)
{
    QFileDialog dialog(&window, DialogText::tr("Save as Recipe"), QFileInfo(start).path(),
                       DialogText::tr("Recipes (*.json)"));
    dialog.setDefaultSuffix(kRecipeSuffix);
    return askForNew(dialog, start);
}

QString askForPicture(QWidget& window, const QString& start)
{
    QFileDialog dialog(&window, DialogText::tr("Save Picture"), QFileInfo(start).path(),
                       DialogText::tr("Pictures (*.png)"));
    dialog.setDefaultSuffix(QStringLiteral("png"));
    return askForNew(dialog, start);
}

QString askForExport(QWidget& window, const QString& start, const Settings& settings)
{
    const QStringList suffixes = exportSuffixes();
    QStringList filters;
    for (const ExportFormat* format : exportFormats())
        filters.append(QStringLiteral("%1 (*.%2)").arg(format->name(), format->suffix()));
    QFileDialog dialog(&window, DialogText::tr("Export"), QFileInfo(start).path());
    dialog.setNameFilters(filters);
    const qsizetype last = std::max<qsizetype>(0, suffixes.indexOf(settings.exportSuffix()));
    dialog.selectNameFilter(filters[last]);
    dialog.setDefaultSuffix(suffixes[last]);
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                     [&dialog, filters, suffixes](const QString& filter) {
                         dialog.setDefaultSuffix(suffixes[std::max<qsizetype>(0, filters.indexOf(filter))]);
                     });
    return askForNew(dialog, start);
}

Unsaved askAboutUnsaved(QWidget& window, const QString& name, bool isGrowing)
{
    QMessageBox question(
        QMessageBox::NoIcon, DialogText::tr("Espalier"),
        isGrowing ? DialogText::tr("%1 is still growing. What has grown so far is not saved.").arg(name)
                  : DialogText::tr("%1 has unsaved changes.").arg(name),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window);
    dress(*question.button(QMessageBox::Save), DialogText::tr("&Save"));
    dress(*question.button(QMessageBox::Discard), DialogText::tr("&Discard"));
    dress(*question.button(QMessageBox::Cancel), DialogText::tr("&Cancel"));
    question.setDefaultButton(QMessageBox::Save);
    switch (question.exec()) {
    case QMessageBox::Save:
        return Unsaved::Save;
    case QMessageBox::Discard:
        return Unsaved::Discard;
    default:
        return Unsaved::Stay;
    }
}

Changed askAboutChanged(QWidget& window, const QString& name)
{
    QMessageBox question(QMessageBox::NoIcon, DialogText::tr("Espalier"),
                         DialogText::tr("%1 has been changed by another window or program since it was "
                                        "opened or saved here. Overwriting it loses those changes.")
                             .arg(name),
                         QMessageBox::Cancel, &window);
    QAbstractButton* saveAs = question.addButton(DialogText::tr("&Save As…"), QMessageBox::AcceptRole);
    QAbstractButton* overwrite =
        question.addButton(DialogText::tr("&Overwrite"), QMessageBox::DestructiveRole);
    dress(*question.button(QMessageBox::Cancel), DialogText::tr("&Cancel"));
    saveAs->setObjectName(QStringLiteral("saveAs"));
    overwrite->setObjectName(QStringLiteral("overwrite"));
    question.setDefaultButton(qobject_cast<QPushButton*>(saveAs));
    question.exec();
    if (question.clickedButton() == saveAs)
        return Changed::SaveAs;
    return question.clickedButton() == overwrite ? Changed::Overwrite : Changed::Cancel;
}

} // namespace espalier::dialogs
