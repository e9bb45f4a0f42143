// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/FilesFixture.h"

#include "app/runners/Background.h"
#include "commands/GrowGesture.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QIODevice>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

namespace espalier::test {

FilesWindow::FilesWindow() : notice(&widget)
{
    widget.resize(800, 600);
    widget.show();
    files = std::make_unique<FileController>(widget, document, settings, notice,
                                             [] { return QImage(8, 8, QImage::Format_RGB32); });
    files->startNew();
}

FilesWindow::~FilesWindow()
{
    files.reset();
}

void FilesWindow::grow(int steps)
{
    GrowGesture gesture(document);
    for (int i = 0; i < steps; ++i)
        gesture.step();
    gesture.finish();
}

void FilesWindow::press(const QString& text)
{
    for (QPushButton* button : notice.findChildren<QPushButton*>()) {
        if (button->isVisibleTo(&notice) && button->text() == text) {
            button->click();
            return;
        }
    }
    QFAIL(qPrintable(QStringLiteral("“%1” has no button “%2”").arg(said(), text)));
}

void FilesFixture::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    QDir(Autosave::folder()).removeRecursively();
    QSettings().clear();
    m_questions = 0;
}

void FilesFixture::cleanup()
{
    backgroundThreads().waitForDone();
}

void FilesFixture::answer(const std::function<QAbstractButton*(QMessageBox&)>& choose)
{
    QTimer::singleShot(20, this, [this, choose] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return answer(choose);
        ++m_questions;
        QAbstractButton* button = choose(*box);
        if (button)
            button->click();
        else
            box->reject();
    });
}

void FilesFixture::answer(QMessageBox::StandardButton button)
{
    answer([button](QMessageBox& box) { return box.button(button); });
}

void FilesFixture::answer(const QString& objectName)
{
    answer([objectName](QMessageBox& box) { return box.findChild<QAbstractButton*>(objectName); });
}

QStringList FilesFixture::copies()
{
    return QDir(Autosave::folder()).entryList({QStringLiteral("*.espalier")}, QDir::Files);
}

void FilesFixture::leaveACopy(const char* name)
{
    for (const QString& copy : copies()) {
        const SafetyCopy own = SafetyCopy::ofProject(Autosave::folder() + QLatin1Char('/') + copy);
        if (FileLock::taken(own.lockFile()))
            continue;
        const SafetyCopy left(Autosave::folder() + QLatin1Char('/') + QLatin1String(name));
        put(left.projectFile(), bytesOf(own.projectFile()));
        put(left.originFile(), bytesOf(own.originFile()));
        if (QFileInfo::exists(own.changesFile()))
            put(left.changesFile(), bytesOf(own.changesFile()));
    }
}

void FilesFixture::save(FilesWindow& window, const QString& fileName)
{
    DocumentFile& file = window.files->file();
    QSignalSpy saved(&file, &DocumentFile::saved);
    file.save(fileName, {});
    QVERIFY(saved.wait(30'000));
}

void FilesFixture::open(FilesWindow& window, const QString& fileName)
{
    QSignalSpy opened(window.files.get(), &FileController::opened);
    window.files->openFile(fileName);
    QVERIFY(opened.wait(30'000));
}

void FilesFixture::put(const QString& fileName, const QByteArray& content)
{
    QVERIFY(QDir().mkpath(QFileInfo(fileName).path()));
    QFile file(fileName);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

QByteArray FilesFixture::bytesOf(const QString& fileName)
{
    QFile file(fileName);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
}

} // namespace espalier::test
