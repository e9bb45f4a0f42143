// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Recovery.h"

#include "app/runners/Background.h"
#include "panels/Notice.h"

#include <QDir>
#include <QLocale>

namespace espalier {

namespace {

/// A safety copy, and the reason why it cannot be read; empty if it can.
struct Tried {
    Leftover leftover;
    QString fault;
    bool isWorthless = false; ///< Nothing was done that could be brought back
};

std::vector<Tried> tryToRead(const std::vector<Leftover>& leftovers)
{
    std::vector<Tried> tried;
    for (const Leftover& leftover : leftovers) {
        const SafetyCopy copy = SafetyCopy::ofProject(leftover.fileName);
        const Result<Project> project = copy.read();
        const bool isSeedling = project && project->journal.empty() && project->tree.size() == 1 &&
                                leftover.original.isEmpty() && project->look == SceneLook();
        tried.push_back({leftover, project ? QString() : project.error().message,
                         project && (isSeedling || !copy.hasChanges())});
    }
    return tried;
}

/// Moves the safety copy aside and returns a sentence about that.
QString sentenceAbout(const Leftover& leftover, const QString& fault)
{
    const QString place = Autosave::keepAside(leftover);
    const QString sentence = fault.endsWith(QLatin1Char('.')) ? fault : fault + QLatin1Char('.');
    return Recovery::tr("The safety copy of %1 cannot be read. %2 It is kept as %3.")
        .arg(leftover.displayName(), sentence, QDir::toNativeSeparators(place));
}

} // namespace

Recovery::Recovery(Notice& notice, QObject* parent) : QObject(parent), m_notice(nullptr)
{
    setNotice(notice);
}

void Recovery::setNotice(Notice& notice)
{
    m_notice = &notice;
    // Queued, because a button of the notice may not have reported the answer yet.
    connect(&notice, &Notice::closed, this, &Recovery::offerNext, Qt::QueuedConnection);
    QMetaObject::invokeMethod(this, &Recovery::offerNext, Qt::QueuedConnection);
}

void Recovery::start()
{
    std::vector<Leftover> leftovers = Autosave::leftovers();
    if (leftovers.empty())
        return;
    runInBackground(
        this, [leftovers = std::move(leftovers)] { return tryToRead(leftovers); },
        [this](const std::vector<Tried>& tried) {
            QStringList unreadable;
            for (const Tried& one : tried) {
                if (one.isWorthless)
                    Autosave::discard(one.leftover);
                else if (one.fault.isEmpty())
                    m_offers.push_back(one.leftover);
                else
                    unreadable.append(sentenceAbout(one.leftover, one.fault));
            }
            tellUnreadable(unreadable);
            offerNext();
        });
}

void Recovery::keepAside(const Leftover& leftover, const QString& reason)
{
    tellUnreadable({sentenceAbout(leftover, reason)});
}

void Recovery::tellUnreadable(const QStringList& sentences)
{
    if (!sentences.isEmpty())
        m_notice->showWarning(sentences.join(QLatin1Char('\n')));
}

void Recovery::offerNext()
{
    if (m_offers.empty() || !m_notice->isHidden())
        return;
    const Leftover& next = m_offers.front();
    m_notice->ask(tr("Espalier ended unexpectedly. %1 can be brought back as it was on %2.")
                      .arg(next.displayName(), QLocale().toString(next.written, QLocale::ShortFormat)),
                  {tr("Bring Back"), tr("Discard"), tr("Later")}, [this](int chosen) { answer(chosen); });
}

void Recovery::answer(int chosen)
{
    if (chosen == 2) {
        m_offers.clear();
        return;
    }
    const Leftover leftover = m_offers.front();
    m_offers.pop_front();
    if (chosen == 0)
        Q_EMIT wanted(leftover);
    else
        Autosave::discard(leftover);
}

} // namespace espalier
