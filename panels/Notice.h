// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"

#include <QTimer>

#include <array>
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
    /// Asks; each answer closes it. Another notice takes the question away without an answer.
    void ask(const QString& text, const QString& yes, const QString& no, std::function<void(bool)> answer);
    /// Asks with one, two or three answers; @p answer is told the index of the one that was chosen.
    void ask(const QString& text, const QStringList& answers, std::function<void(int)> answer);
    void finish() { hide(); }
    /// Goes away if it shows progress.
    void finishProgress();

    QString text() const;
    bool isWarning() const { return m_isWarning; }

Q_SIGNALS:
    /// It needs another place or size now.
    void resized();
    /// It went away, answered or not.
    void closed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void present(const QString& text, bool warning, const QStringList& answers);

    QLabel* m_text;
    QProgressBar* m_progress;
    std::array<QPushButton*, 3> m_buttons{};
    QTimer m_timer;
    bool m_isWarning = false;
    std::function<void(int)> m_answer;
};

} // namespace espalier
