// SPDX-License-Identifier: GPL-3.0-or-later
// A program that edits, saves and exports at random until the test kills it; see KillTest.cpp. It prints what
// it does, a line each, before and after it is done:
//   doing N              the N-th operation begins
//   done N DIGEST MS   the N-th operation was finished at that time, and gave a document with that digest
//   safe N             the safety copy has all operations up to the N-th
//   clean              all that is not saved was undone: there is nothing to keep, and the next copy begins
//   anew saving N FILE      the document after the N-th operation is going to be written saved FILE exporting
//   FILE, exported FILE
#include "app/TerminationSignals.h"
#include "app/files/FileController.h"
#include "panels/Notice.h"
#include "tests/kill/DocumentDigest.h"
#include "tests/soak/Hand.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QTimer>

#include <cstdio>

using namespace espalier;
using namespace espalier::test;

namespace {

void tell(const QString& line)
{
    std::puts(qPrintable(line));
    std::fflush(stdout);
}

class Victim : public QObject {
public:
    Victim(const QDir& folder, std::uint64_t seed)
        : m_folder(folder),
          m_random(seed, 300),
          m_notice(&m_widget),
          m_files(m_widget, m_document, m_settings, m_notice, [] { return QImage(); })
    {
        m_files.startNew();
        tell(QStringLiteral("begins ") + digestOf(projectOf(m_document, {})));
        connect(&m_files.autosave(), &Autosave::written, this,
                [this] { tell(QStringLiteral("safe %1").arg(m_done)); });
        connect(&m_files.file(), &DocumentFile::saved, this,
                [](const QString& name) { tell(QStringLiteral("saved ") + name); });
        connect(&m_signals, &TerminationSignals::asked, this, [this] {
            m_isEnding = true;
            m_document.interruptEdit();
            m_files.leave();
            QCoreApplication::exit();
        });
        QTimer::singleShot(0, this, &Victim::act);
    }

private:
    void act()
    {
        // Saving waits in an event loop.
        if (m_isEnding)
            return;
        if (m_random.onceIn(12))
            save();
        else if (m_random.onceIn(12))
            exportTree();
        else
            edit();
        // Between operations the hand rests now and then.
        QTimer::singleShot(m_random.onceIn(4) ? m_random.below(120) : 0, this, &Victim::act);
    }

    void edit()
    {
        tell(QStringLiteral("doing %1").arg(m_done + 1));
        const int undoable = m_document.undoStack().index();
        m_isEditing = true;
        doByHand(m_document, m_random.next(m_document, undoable), m_random);
        m_isEditing = false;
        // The clock of the system, which the test has, too.
        QElapsedTimer now;
        now.start();
        const qint64 time = now.msecsSinceReference();
        tell(
            QStringLiteral("done %1 %2 %3").arg(++m_done).arg(digestOf(projectOf(m_document, {}))).arg(time));
    }

    void save()
    {
        if (m_files.file().isSaving())
            return;
        const QString name = m_folder.filePath(QStringLiteral("tree%1.espalier").arg(m_random.below(2)));
        tell(QStringLiteral("saving %1 %2").arg(m_done).arg(name));
        m_files.file().save(name, {}, DocumentFile::Overwrite::Anything);
    }

    void exportTree()
    {
        const QString name =
            m_folder.filePath(QStringLiteral("tree.%1").arg(m_random.onceIn(2) ? "glb" : "obj"));
        tell(QStringLiteral("exporting ") + name);
        m_files.exportTo(name);
    }

    QDir m_folder;
    RandomOperations m_random;
    QWidget m_widget;
    Settings m_settings;
    Notice m_notice;
    TreeDocument m_document;
    bool m_isEditing = false;
    /// Before the safety copy hears of it.
    QMetaObject::Connection m_cleanTold =
        connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, [this] {
            if (m_isEditing && m_document.undoStack().isClean())
                tell(QStringLiteral("clean"));
        });
    FileController m_files;
    TerminationSignals m_signals;
    int m_done = 0;
    bool m_isEnding = false;
};

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-victim"));
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 3)
        return 2;
    const Victim victim(QDir(arguments[1]), arguments[2].toULongLong());
    return QApplication::exec();
}
