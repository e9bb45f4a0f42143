// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/AnotherPanel.h"

#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace espalier {

namespace {

constexpr int kAcross = 3;     ///< Pictures in a row
constexpr int kPictureRim = 6; ///< Around a picture, px
constexpr int kLeast = 120;    ///< px
constexpr int kMost = 280;     ///< px

} // namespace

int AnotherPanel::pictureIn(const QSize& window)
{
    // Bars are beside the panel, and its title and buttons take some of the height.
    return std::clamp(
        std::min((window.width() - 220) / kAcross - 2 * kPictureRim, (window.height() - 330) / 2), kLeast,
        kMost);
}

AnotherPanel::AnotherPanel(QWidget* parent) : Bar(parent), m_state(new QLabel(this))
{
    setOpaque(true);
    setAccessibleName(tr("Another Like This"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 12, 14, 12);
    column->setSpacing(8);
    auto* head = new QHBoxLayout;
    head->addWidget(barHeading(tr("Another Like This"), this), 1);
    auto* close = new BarButton(BarButton::Look::Icon, this);
    close->setObjectName(QStringLiteral("anotherClose"));
    close->setIcon(icon(QStringLiteral("close")));
    close->setToolTip(tr("Close"));
    close->setAccessibleName(tr("Close"));
    head->addWidget(close);
    column->addLayout(head);
    auto* grid = new QGridLayout;
    grid->setSpacing(kPictureRim);
    column->addLayout(grid);
    for (int i = 0; i < kCount; ++i) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("another%1").arg(i));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setProperty("look", "tool");
        button->setAccessibleName(tr("Tree %1 of %2").arg(i + 1).arg(kCount));
        button->setToolTip(tr("Take this tree in place of yours. Undo brings yours back."));
        connect(button, &QToolButton::clicked, this, [this, i] { Q_EMIT chosen(i); });
        grid->addWidget(button, i / kAcross, i % kAcross);
        m_buttons[static_cast<std::size_t>(i)] = button;
    }
    auto* foot = new QHBoxLayout;
    theme::setTone(*m_state, theme::Tone::Dim);
    foot->addWidget(m_state, 1);
    auto* more = new QPushButton(tr("Six More"), this);
    more->setObjectName(QStringLiteral("anotherMore"));
    more->setMinimumHeight(theme::kTarget);
    more->setFocusPolicy(Qt::TabFocus);
    foot->addWidget(more);
    column->addLayout(foot);
    connect(close, &QToolButton::clicked, this, &AnotherPanel::closeAsked);
    connect(more, &QPushButton::clicked, this, &AnotherPanel::moreAsked);
    setPictureSize(kLeast);
    clear();
    hide();
}

void AnotherPanel::setPictureSize(int edge)
{
    for (QToolButton* button : m_buttons) {
        button->setIconSize({edge, edge});
        button->setFixedSize(edge + 2 * kPictureRim, edge + 2 * kPictureRim);
    }
    // Also while the panel is hidden, so that its size hint is right.
    for (QLayout* part : findChildren<QLayout*>())
        part->invalidate();
    layout()->activate();
}

void AnotherPanel::clear()
{
    m_missing = kCount;
    m_state->setText(tr("They are growing…"));
    for (QToolButton* button : m_buttons) {
        button->setIcon({});
        button->setEnabled(false);
    }
}

void AnotherPanel::setPicture(int number, const QImage& picture)
{
    QToolButton* button = m_buttons[static_cast<std::size_t>(number)];
    button->setIcon(QIcon(QPixmap::fromImage(picture)));
    button->setEnabled(!picture.isNull());
    if (--m_missing <= 0)
        m_state->setText(tr("The same strokes; only chance differs."));
}

void AnotherPanel::takeFocus()
{
    m_buttons.front()->setFocus(Qt::OtherFocusReason);
}

} // namespace espalier
