// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/LeafChoices.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr int kColumns = 2;
constexpr int kButtonEdge = 4; ///< px

struct EngineText {
    const char* name;
    const char* tip;
};

/// In the order of kLeafEngines.
constexpr std::array<EngineText, kLeafEngines.size()> kEngineTexts{{
    {QT_TRANSLATE_NOOP("espalier::LeafChoices", "One more"),
     QT_TRANSLATE_NOOP("espalier::LeafChoices",
                       "One more leaf at this place; all of them stand evenly around the branch.")},
    {QT_TRANSLATE_NOOP("espalier::LeafChoices", "Whorls"),
     QT_TRANSLATE_NOOP("espalier::LeafChoices",
                       "Whorls like this along the whole branch, at the same spacing.")},
    {QT_TRANSLATE_NOOP("espalier::LeafChoices", "Alternate"),
     QT_TRANSLATE_NOOP("LeafChoices", "One leaf at a time along the branch, each turned from the one before "
                                      "as the second is from the first.")},
    {QT_TRANSLATE_NOOP("espalier::LeafChoices", "Opposite"),
     QT_TRANSLATE_NOOP("espalier::LeafChoices", "Pairs of leaves along the branch, all in one plane.")},
    {QT_TRANSLATE_NOOP("espalier::LeafChoices", "Decussate"),
     QT_TRANSLATE_NOOP("espalier::LeafChoices",
                       "Pairs of leaves along the branch, each across the one below it.")},
}};

} // namespace

LeafChoices::LeafChoices(QWidget* parent) : Bar(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(2);
    column->addWidget(barHeading(tr("Continue with"), this));
    m_grid = new QGridLayout;
    m_grid->setSpacing(2);
    column->addLayout(m_grid);
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("leafChoice%1").arg(i));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setProperty("look", "tool");
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setIconSize({kPicture, kPicture});
        button->setMinimumWidth(kPicture + 2 * kButtonEdge);
        const QString name = tr(kEngineTexts[i].name);
        button->setText(name);
        button->setToolTip(tr("<b>%1</b><br>%2").arg(name, tr(kEngineTexts[i].tip)));
        button->hide();
        connect(button, &QToolButton::clicked, this, [this, i] { Q_EMIT chosen(kLeafEngines[i]); });
        m_buttons[i] = button;
    }
    hide();
}

void LeafChoices::offer(const std::array<QImage, kLeafEngines.size()>& pictures)
{
    int count = 0;
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setIcon(QIcon(QPixmap::fromImage(pictures[i])));
        m_buttons[i]->setVisible(!pictures[i].isNull());
        m_grid->removeWidget(m_buttons[i]);
        if (pictures[i].isNull())
            continue;
        m_grid->addWidget(m_buttons[i], count / kColumns, count % kColumns, Qt::AlignHCenter);
        ++count;
    }
    m_isOffering = count > 0;
    updateGeometry();
    Q_EMIT offerChanged();
}

} // namespace espalier
