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

/// One sentence over the tree: what was done, what went wrong, or the progress of a task. It never blocks the
/// work.
class Notice : public Bar {
    Q_OBJECT

public:
    explicit Notice(QWidget* parent = nullptr);

    /// Shows a sentence that disappears after some time.
    void showInformation(const QString& text);
    /// The same with a button @p action, which calls @p done.
    void showInformation(const QString& text, const QString& action, std::function<void()> done);
    /// Shows a sentence that stays until the user closes it.
    void showWarning(const QString& text);
    /// Shows that @p task has the progress 0...1, or that it takes an unknown time (below 0), and a button to
    /// cancel if @p cancel is given; until the next notice, finish() or finishProgress(@p task).
    void showProgress(const QObject& task, const QString& text, double progress,
                      std::function<void()> cancel = {});
    /// Shows a question; each answer closes it. Another notice removes the question without an answer.
    void ask(const QString& text, const QString& yes, const QString& no, std::function<void(bool)> answer);
    /// Shows a question with one, two or three answers; @p answer gets the index of the chosen one.
    void ask(const QString& text, const QStringList& answers, std::function<void(int)> answer);
    void finish() { hide(); }
    /// Closes the notice if it shows the progress of @p task.
    void finishProgress(const QObject& task);
    /// Whether the notice shows the progress of @p task.
    bool showsProgressOf(const QObject& task) const { return m_task == &task && !isHidden(); }

    /// Whether the notice has a button for an answer, an action or to cancel.
    bool isAsking() const;

    QString text() const;
    bool isWarning() const { return m_isWarning; }

Q_SIGNALS:
    /// The notice needs another place or size now.
    void resized();
    /// The notice was closed, with or without an answer.
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
    const QObject* m_task = nullptr; ///< Whose progress is shown. Only compared, because it may have gone
    std::function<void(int)> m_answer;
};

} // namespace espalier
