// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/HandOver.h"
#include "model/base/WithinMemory.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

#include <memory>
#include <utility>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace espalier {

/// Niceness of threads that work in the background, −20...19.
inline constexpr int kBackgroundNiceness = 10;

/// The threads of runInBackground(). They are not those of QThreadPool::globalInstance(): Qt paints large
/// shapes with these and waits for them, so a window would wait for the work.
inline QThreadPool& backgroundThreads()
{
    static QThreadPool threads;
    // What still runs when the program ends uses the application object.
    [[maybe_unused]] static const bool isAwaited = [] {
        qAddPostRoutine([] { backgroundThreads().waitForDone(); });
        return true;
    }();
    return threads;
}

/// Calls @p work() on a worker thread, then @p done(its result) on the GUI thread, unless @p owner has been
/// destroyed by then. @p work must own all that it uses, as snapshots and values. A Result<> tells if there
/// was not enough memory.
template <class Work, class Done>
void runInBackground(QObject* owner, Work work, Done done)
{
    backgroundThreads().start([guard = QPointer<QObject>(owner), work = std::move(work),
                               done = std::move(done), handOver = HandOver()]() mutable {
        handOver.take();
#ifdef Q_OS_LINUX
        // With few cores, the window must come first. Linux ignores Qt's thread priorities.
        setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kBackgroundNiceness);
#endif
        auto result = std::make_shared<decltype(work())>(withinMemory(work));
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [guard = std::move(guard), result = std::move(result), done = std::move(done),
             back = HandOver()]() mutable {
                back.take();
                {
                    // What the work and its end have brought is destroyed here: Qt lets the worker destroy
                    // this lambda if the worker is the last to leave it.
                    const auto taken = std::move(result);
                    auto finish = std::move(done);
                    if (guard)
                        finish(std::move(*taken));
                }
                back.give();
            },
            Qt::QueuedConnection);
    });
}

} // namespace espalier
