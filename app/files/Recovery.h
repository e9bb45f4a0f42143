// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Autosave.h"

#include <QObject>

#include <deque>

namespace espalier {

class Notice;

/// Offers everything that crashes have left behind, one safety copy after another, the newest first. A safety
/// copy that cannot be read is kept aside, and a notice says where; it is never deleted. Other notices may
/// cover the question; it comes back after them.
class Recovery : public QObject {
    Q_OBJECT

public:
    explicit Recovery(Notice& notice, QObject* parent = nullptr);
    /// Shows everything there from now on.
    void setNotice(Notice& notice);

    /// Looks for safety copies; those that can be read are offered, once a worker thread has tried.
    void start();
    /// Keeps a safety copy aside that turned out to be unreadable after all; @p reason names the fault.
    void keepAside(const Leftover& leftover, const QString& reason);

Q_SIGNALS:
    /// The person wants this one back.
    void wanted(const espalier::Leftover& leftover);

private:
    void tellUnreadable(const QStringList& sentences);
    void offerNext();
    void answer(int chosen);

    Notice* m_notice;
    std::deque<Leftover> m_offers;
};

} // namespace espalier
