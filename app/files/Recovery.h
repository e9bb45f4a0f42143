// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Autosave.h"

#include <QObject>

#include <deque>

namespace espalier {

class Notice;

/// Offers all safety copies that crashes have left behind, one after another, the newest first. A safety copy
/// that cannot be read is moved aside, and a notice says where; it is never deleted. Another notice can cover
/// the question; the question comes back after it.
class Recovery : public QObject {
    Q_OBJECT

public:
    explicit Recovery(Notice& notice, QObject* parent = nullptr);
    /// Sets the notice that shows the questions and messages from now on.
    void setNotice(Notice& notice);

    /// Looks for safety copies; those that can be read are offered, once a worker thread has tried.
    void start();
    /// Moves a safety copy aside that turned out to be unreadable after it was offered; @p reason names the
    /// fault.
    void keepAside(const Leftover& leftover, const QString& reason);

Q_SIGNALS:
    /// The user wants to recover this leftover.
    void wanted(const espalier::Leftover& leftover);

private:
    void tellUnreadable(const QStringList& sentences);
    void offerNext();
    void answer(int chosen);

    Notice* m_notice;
    std::deque<Leftover> m_offers;
};

} // namespace espalier
