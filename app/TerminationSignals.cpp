// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/TerminationSignals.h"

#include <QSocketNotifier>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace espalier {

namespace {

constexpr std::array kSignals{SIGTERM, SIGINT, SIGHUP};
/// A signal handler may only write into the pipe; the event loop reads from it.
std::array<int, 2> signalPipe{-1, -1};

void handle(int number)
{
    const int before = errno;
    const char byte = 0;
    static_cast<void>(!::write(signalPipe[1], &byte, 1));
    std::signal(number, SIG_DFL);
    errno = before;
}

} // namespace

TerminationSignals::TerminationSignals(QObject* parent) : QObject(parent)
{
    if (::pipe2(signalPipe.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return;
    m_notifier = new QSocketNotifier(signalPipe[0], QSocketNotifier::Read, this);
    connect(m_notifier, &QSocketNotifier::activated, this, [this] {
        char byte = 0;
        while (::read(signalPipe[0], &byte, 1) > 0) {
        }
        Q_EMIT asked();
    });
    for (const int number : kSignals) {
        // "nohup" lets the program live on.
        if (std::signal(number, handle) == SIG_IGN)
            std::signal(number, SIG_IGN);
    }
}

TerminationSignals::~TerminationSignals()
{
    for (const int number : kSignals)
        std::signal(number, SIG_DFL);
    for (int& end : signalPipe)
        ::close(std::exchange(end, -1));
}

} // namespace espalier
