// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/input/LatinKey.h"

#include <QHash>
#include <QObject>

class QKeyEvent;

namespace espalier {

/// Makes shortcuts work on keyboards whose layout has no Latin letters (Cyrillic, Greek, Hebrew...): a key
/// gets the meaning that the key at the same place of a US keyboard has, so that Ctrl+Z is where it always
/// is. The object filters the application's events from its construction on. Text that the user types into a
/// text field does not change, unless Ctrl, Alt or Meta is held.
class LatinKeyFilter : public QObject {
    Q_OBJECT

public:
    explicit LatinKeyFilter(QObject* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    int meantKey(const QKeyEvent& event);

    KeyCodes m_codes;
    /// Whether the last letter was not Latin: then a sign at the place of a Latin letter means that letter.
    bool m_isSending = false;
    bool m_isLayoutForeign = false;
    QHash<quint32, int> m_held; ///< What held keys mean, by their native codes
};

} // namespace espalier
