// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Notice.h"

#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>

namespace espalier {

namespace {

// Widths of the sentence, px; a longer one takes several lines.
constexpr int kLeastText = 160;
constexpr int kMostText = 520;
constexpr int kProgressSteps = 1000;
constexpr int kShown = 4000; ///< ms

} // namespace

Notice::Notice(QWidget* parent) : Bar(parent), m_text(new QLabel(this)), m_progress(new QProgressBar(this))
{
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_progress->setFixedWidth(180);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(8);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        auto* button = new QPushButton(this);
        m_buttons[i] = button;
        button->setMinimumHeight(theme::kTarget);
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QPushButton::clicked, this, [this, i] {
            hide();
            if (const auto told = std::exchange(m_answer, {}))
                told(static_cast<int>(i));
        });
    }
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(18, 8, 12, 8);
    line->setSpacing(10);
    line->addWidget(m_text, 1);
    line->addWidget(m_progress);
    for (QPushButton* button : m_buttons)
        line->addWidget(button);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &QWidget::hide);
    hide();
}

QString Notice::text() const
{
    return m_text->text();
}

bool Notice::isAsking() const
{
    return !isHidden() && !m_buttons.front()->isHidden();
}

void Notice::showInformation(const QString& text)
{
    m_answer = {};
    present(text, false, {});
    m_timer.start(kShown);
}

void Notice::showInformation(const QString& text, const QString& action, std::function<void()> done)
{
    constexpr int kLonger = 10'000; // ms: the button takes time to reach
    m_answer = [done = std::move(done)](int) { done(); };
    present(text, false, {action});
    m_timer.start(kLonger);
}

void Notice::showWarning(const QString& text)
{
    m_answer = {};
    present(text, true, {tr("Close")});
}

void Notice::showProgress(const QObject& task, const QString& text, double progress,
                          std::function<void()> cancel)
{
    const bool cancellable = static_cast<bool>(cancel);
    m_answer = [cancel = std::move(cancel)](int) {
        if (cancel)
            cancel();
    };
    m_progress->setRange(0, progress < 0.0 ? 0 : kProgressSteps);
    m_progress->setValue(static_cast<int>(progress * kProgressSteps));
    present(text, false, cancellable ? QStringList{tr("Cancel")} : QStringList());
    m_task = &task;
    m_progress->show();
    Q_EMIT resized();
}

void Notice::ask(const QString& text, const QString& yes, const QString& no, std::function<void(bool)> answer)
{
    ask(text, {yes, no}, [answer = std::move(answer)](int chosen) { answer(chosen == 0); });
}

void Notice::ask(const QString& text, const QStringList& answers, std::function<void(int)> answer)
{
    m_answer = std::move(answer);
    present(text, false, answers);
}

void Notice::finishProgress(const QObject& task)
{
    if (showsProgressOf(task))
        hide();
}

void Notice::present(const QString& text, bool warning, const QStringList& answers)
{
    m_timer.stop();
    m_isWarning = warning;
    m_task = nullptr;
    m_text->setText(text);
    m_text->setFixedWidth(
        std::clamp(m_text->fontMetrics().horizontalAdvance(text) + 4, kLeastText, kMostText));
    m_progress->hide();
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const QString name = answers.value(static_cast<qsizetype>(i));
        m_buttons[i]->setText(name);
        m_buttons[i]->setVisible(!name.isEmpty());
    }
    show();
    raise();
    Q_EMIT resized();
    update();
}

void Notice::hideEvent(QHideEvent* event)
{
    Bar::hideEvent(event);
    if (isHidden()) // false if only the window around the notice is hidden
        Q_EMIT closed();
}

void Notice::paintEvent(QPaintEvent* event)
{
    Bar::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_isWarning ? theme::kWarning : theme::kAccent);
    painter.drawRoundedRect(QRectF(6, 10, 3, height() - 20), 1.5, 1.5);
}

} // namespace espalier
