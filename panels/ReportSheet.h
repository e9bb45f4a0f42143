// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <functional>

class QCheckBox;
class QPlainTextEdit;

namespace espalier {

/// The dialog that shows what a report of a problem should have, to copy it. Nothing is sent.
class ReportSheet : public QDialog {
    Q_OBJECT

public:
    /// @p facts: about the program and the machine, and the log. @p recipe makes the recipe of the tree, or a
    /// sentence; it is called when the user wants it.
    ReportSheet(const QString& facts, std::function<QString()> recipe, QWidget* parent = nullptr);

    /// The text that is shown, and copied.
    QString text() const;

private:
    void showText();
    void copy();

    QString m_facts;
    std::function<QString()> m_recipe;
    QPlainTextEdit* m_text;
    QCheckBox* m_withRecipe;
};

} // namespace espalier
