// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"

#include <QTimer>

#include <functional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace espalier {

/// One sentence over the tree: what was done, what went wrong, or how far something has got. It never stops
/// the work.
class Notice : public Bar {
    Q_OBJECT

public:
    explicit Notice(QWidget* parent = nullptr);

    /// Goes away by itself.
    void showInformation(const QString& text);
    /// Stays until it is closed.
    void showWarning(const QString& text);
    /// Shows progress of 0...1, or that it takes an unknown time (below 0), and a way to cancel if @p cancel
    /// is given; until another notice or finish().
    void showProgress(const QString& text, double progress, std::function<void()> cancel = {});
    /// Asks; either answer closes it.
    void ask(const QString& text, const QString& yes, const QString& no, std::function<void(bool)> answer);
    void finish() { hide(); }

    QString text() const;
    bool isWarning() const { return m_isWarning; }

Q_SIGNALS:
    /// It needs another place or size now.
    void resized();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void present(const QString& text, bool warning, const QString& yes, const QString& no);

    QLabel* m_text;
    QProgressBar* m_progress;
    QPushButton* m_yes;
    QPushButton* m_no;
    QTimer m_timer;
    bool m_isWarning = false;
    std::function<void(bool)> m_answer;
};

} // namespace espalier
