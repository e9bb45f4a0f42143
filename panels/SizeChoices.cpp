// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/SizeChoices.h"

#include "model/settings/Lengths.h"
#include "panels/Icon.h"
#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kButtonWidth = 92; ///< px

QString nameOf(TreeSize size)
{
    switch (size) {
    case TreeSize::Bonsai:
        return SizeChoices::tr("Bonsai");
    case TreeSize::Shrub:
        return SizeChoices::tr("Shrub");
    case TreeSize::StreetTree:
        return SizeChoices::tr("Street Tree");
    case TreeSize::ForestTree:
        return SizeChoices::tr("Forest Tree");
    }
    return {};
}

QString iconOf(TreeSize size)
{
    // In the order of TreeSize
    static const std::array icons{QStringLiteral("sizeBonsai"), QStringLiteral("sizeShrub"),
                                  QStringLiteral("sizeStreetTree"), QStringLiteral("sizeForestTree")};
    return icons[static_cast<std::size_t>(size)];
}

} // namespace

SizeChoices::SizeChoices(QWidget* parent) : Bar(parent)
{
    setAccessibleName(tr("Size of the new tree"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 8, 6);
    column->setSpacing(2);
    auto* title = new QLabel(tr("How tall should the new tree grow?"), this);
    title->setAlignment(Qt::AlignCenter);
    theme::setTone(*title, theme::Tone::Dim);
    column->addWidget(title);
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    column->addLayout(line);
    for (int i = 0; i < kTreeSizeCount; ++i) {
        const auto size = static_cast<TreeSize>(i);
        auto* button = new BarButton(BarButton::Look::IconAboveText, this);
        const QString height = roundLengthText(sizePreset(size).height);
        button->setObjectName(iconOf(size));
        button->setText(nameOf(size));
        button->setIcon(icon(iconOf(size)));
        button->setCheckable(true);
        button->setAutoExclusive(true);
        button->setMinimumWidth(kButtonWidth);
        button->setToolTip(tr("<b>%1</b><br>About %2 tall; the brush, the branches and the leaves are in "
                              "proportion.")
                               .arg(nameOf(size).toHtmlEscaped(), height.toHtmlEscaped()));
        connect(button, &QAbstractButton::clicked, this, [this, size] { Q_EMIT sizeAsked(size); });
        line->addWidget(button);
        m_buttons[static_cast<std::size_t>(i)] = button;
    }
}

void SizeChoices::setSize(TreeSize size)
{
    m_buttons[static_cast<std::size_t>(size)]->setChecked(true);
}

} // namespace espalier
