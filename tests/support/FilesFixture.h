// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/FileController.h"
#include "panels/Notice.h"

#include <QMessageBox>
#include <QTemporaryDir>
#include <QWidget>

#include <functional>
#include <memory>

class QAbstractButton;

namespace espalier::test {

/// A document and the objects that handle its files, without the rest of a window.
struct FilesWindow {
    FilesWindow();
    ~FilesWindow();

    /// Grows, as one undo step.
    void grow(int steps = 3);
    QString said() const { return notice.text(); }
    /// Presses the button of the notice that is shown.
    void press(const QString& text);

    QWidget widget;
    Settings settings;
    Notice notice;
    TreeDocument document;
    std::unique_ptr<FileController> files;
};

/// Safety copies are separate for each test, and autosave is quick.
class FilesFixture : public QObject {
    Q_OBJECT

protected Q_SLOTS:
    void init();
    void cleanup();

protected:
    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    /// Presses a button of the next message box: a standard button's name or an object name.
    void answer(QMessageBox::StandardButton button);
    void answer(const QString& objectName);
    int questions() const { return m_questions; }
    /// Safety copies of all programs.
    static QStringList copies();
    /// Copies the files of the safety copy that a living program writes, under @p name, as a crash would
    /// leave them.
    static void leaveACopy(const char* name);
    void save(FilesWindow& window, const QString& fileName);
    void open(FilesWindow& window, const QString& fileName);
    static void put(const QString& fileName, const QByteArray& content);
    static QByteArray bytesOf(const QString& fileName);

    std::unique_ptr<QTemporaryDir> m_folder;

private:
    void answer(const std::function<QAbstractButton*(QMessageBox&)>& choose);

    int m_questions = 0; ///< Answered so far in this test
};

} // namespace espalier::test
