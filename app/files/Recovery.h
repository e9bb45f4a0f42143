// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Autosave.h"
#include "app/runners/PictureRunner.h"

#include <QObject>
#include <QPointer>

#include <vector>

class QWidget;

namespace espalier {

class Notice;
class RecoverySheet;

/// Offers all safety copies that crashes have left behind in one dialog, the newest first. A safety copy that
/// cannot be read is moved aside, and a notice says where; it is never deleted.
class Recovery : public QObject {
    Q_OBJECT

public:
    Recovery(QWidget& window, Notice& notice, QObject* parent = nullptr);
    /// Sets the notice that shows messages from now on.
    void setNotice(Notice& notice) { m_notice = &notice; }

    enum class Occasion {
        Start, ///< Nothing is said if there is nothing to offer
        Asked,
    };
    /// Looks for safety copies; those that can be read are offered, once a worker thread has tried.
    void start(Occasion occasion);
    /// Says that there are more, if there are, after one has been brought back.
    void remind();
    /// Moves a safety copy aside that turned out to be unreadable after it was offered.
    void keepAside(const Leftover& leftover);

Q_SIGNALS:
    /// The user wants to recover this leftover.
    void wanted(const espalier::Leftover& leftover);

private:
    struct Compared;

    void offer(Occasion occasion);
    void tell();
    void compare(std::size_t index);
    void draw(std::size_t index, std::shared_ptr<Compared> compared);
    void end();

    QWidget& m_window;
    Notice* m_notice;
    std::vector<Leftover> m_offers; ///< As in the sheet
    QPointer<RecoverySheet> m_sheet;
    PictureRunner m_pictures;
    QString m_toTell;                      ///< About safety copies that cannot be read
    bool m_isLooking = false;              ///< A worker thread tries the safety copies
    Occasion m_occasion = Occasion::Start; ///< Of the look
};

} // namespace espalier
