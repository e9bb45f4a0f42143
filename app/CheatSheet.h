// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace espalier {

/// All keys and gestures on one sheet, made from the table of actions.
class CheatSheet : public QDialog {
    Q_OBJECT

public:
    explicit CheatSheet(QWidget* parent = nullptr);
};

} // namespace espalier
