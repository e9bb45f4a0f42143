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

} // namespace

Notice::Notice(QWidget* parent)
    : Bar(parent),
      m_text(new QLabel(this)),
      m_progress(new QProgressBar(this)),
      m_yes(new QPushButton(this)),
      m_no(new QPushButton(this))
{
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_progress->setFixedWidth(180);
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(8);
    for (QPushButton* button : {m_yes, m_no}) {
        button->setMinimumHeight(theme::kTarget);
        button->setFocusPolicy(Qt::TabFocus);
        const bool answer = button == m_yes;
        connect(button, &QPushButton::clicked, this, [this, answer] {
            hide();
            if (const auto told = std::exchange(m_answer, {}))
                told(answer);
        });
    }
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(18, 8, 12, 8);
    line->setSpacing(10);
    line->addWidget(m_text, 1);
    line->addWidget(m_progress);
    line->addWidget(m_yes);
    line->addWidget(m_no);
    m_timer.setSingleShot(true);
    m_timer.setInterval(4000);
    connect(&m_timer, &QTimer::timeout, this, &QWidget::hide);
    hide();
}

QString Notice::text() const
{
    return m_text->text();
}

void Notice::showInformation(const QString& text)
{
    m_answer = {};
    present(text, false, {}, {});
    m_timer.start();
}

void Notice::showWarning(const QString& text)
{
    m_answer = {};
    present(text, true, {}, tr("Close"));
}

void Notice::showProgress(const QString& text, double progress, std::function<void()> cancel)
{
    const bool cancellable = static_cast<bool>(cancel);
    m_answer = [cancel = std::move(cancel)](bool) {
        if (cancel)
            cancel();
    };
    m_progress->setRange(0, progress < 0.0 ? 0 : kProgressSteps);
    m_progress->setValue(static_cast<int>(progress * kProgressSteps));
    present(text, false, {}, cancellable ? tr("Cancel") : QString());
    m_progress->show();
    Q_EMIT resized();
}

void Notice::ask(const QString& text, const QString& yes, const QString& no, std::function<void(bool)> answer)
{
    m_answer = std::move(answer);
    present(text, false, yes, no);
}

void Notice::present(const QString& text, bool warning, const QString& yes, const QString& no)
{
    m_timer.stop();
    m_isWarning = warning;
    m_text->setText(text);
    m_text->setFixedWidth(
        std::clamp(m_text->fontMetrics().horizontalAdvance(text) + 4, kLeastText, kMostText));
    m_progress->hide();
    m_yes->setText(yes);
    m_yes->setVisible(!yes.isEmpty());
    m_no->setText(no);
    m_no->setVisible(!no.isEmpty());
    show();
    raise();
    Q_EMIT resized();
    update();
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
