// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/ExportQueue.h"

#include "app/files/Outputs.h"
#include "app/runners/Background.h"
#include "panels/Notice.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>

#include <utility>

namespace espalier {

ExportQueue::ExportQueue(Notice& notice, QObject* parent) : QObject(parent), m_notice(notice) {}

ExportQueue::~ExportQueue()
{
    if (!m_exports.empty())
        m_exports.front()->isCancelled = true;
}

void ExportQueue::add(Project project, const QString& fileName)
{
    auto added = std::make_shared<Export>();
    added->project = std::move(project);
    added->fileName = fileName;
    added->shortName = QFileInfo(fileName).fileName();
    m_exports.push_back(std::move(added));
    if (m_exports.size() == 1)
        begin();
    else
        show(m_share);
}

void ExportQueue::begin()
{
    const std::shared_ptr<Export> current = m_exports.front();
    show(0.0);
    const auto tell = [guard = QPointer<ExportQueue>(this), current](double share) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [guard, current, share] {
                if (guard && !current->isCancelled && !guard->m_exports.empty() &&
                    guard->m_exports.front() == current)
                    guard->show(share);
            },
            Qt::QueuedConnection);
        return !current->isCancelled;
    };
    runInBackground(
        this, [current, tell] { return writeOutput(current->project, current->fileName, tell); },
        [this](const Result<void>& written) { end(written); });
}

void ExportQueue::show(double share)
{
    m_share = share;
    const std::shared_ptr<Export>& current = m_exports.front();
    const QString text = m_exports.size() == 1
                             ? tr("Writing %1").arg(current->shortName)
                             : tr("Writing %1, then %2").arg(current->shortName, m_exports[1]->shortName);
    m_notice.showProgress(*this, text, share, [current] { current->isCancelled = true; });
}

void ExportQueue::end(const Result<void>& written)
{
    const std::shared_ptr<Export> ended = m_exports.front();
    m_exports.pop_front();
    if (written)
        m_written.push_back(ended->shortName);
    else if (written.error().kind == Error::Kind::Cancelled)
        m_notWritten.push_back(tr("%1 was not written.").arg(ended->shortName));
    else
        m_notWritten.push_back(tr("Not exported. %1").arg(written.error().message));
    m_hasFailed |= !written && written.error().kind != Error::Kind::Cancelled;
    if (m_exports.empty())
        tellResults();
    else
        begin();
}

void ExportQueue::tellResults()
{
    QStringList sentences = std::exchange(m_notWritten, {});
    if (const QStringList names = std::exchange(m_written, {}); !names.isEmpty())
        sentences.push_back(tr("Wrote %1").arg(names.join(QLatin1String(", "))));
    const QString text = sentences.join(QLatin1Char(' '));
    if (std::exchange(m_hasFailed, false))
        m_notice.showWarning(text);
    else
        m_notice.showInformation(text);
}

} // namespace espalier
