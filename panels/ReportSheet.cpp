// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ReportSheet.h"

#include "panels/Theme.h"
#include "panels/Toggle.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace espalier {

namespace {

constexpr QSize kTextSize(560, 260);

} // namespace

ReportSheet::ReportSheet(const QString& facts, std::function<QString()> recipe, QWidget* parent)
    : QDialog(parent),
      m_facts(facts),
      m_recipe(std::move(recipe)),
      m_text(new QPlainTextEdit(this)),
      m_withRecipe(new Toggle(tr("With the recipe of this tree"), this))
{
    setWindowTitle(tr("Report a Problem"));
    auto* note = new QLabel(tr("Copy this text, and add what you did and what happened. Espalier sends "
                               "nothing by itself. Without the recipe, "
                               "the text has nothing of your tree."),
                            this);
    note->setWordWrap(true);
    note->setTextFormat(Qt::PlainText);
    m_text->setReadOnly(true);
    m_text->setMinimumSize(kTextSize);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setAccessibleName(tr("Text of the report"));
    m_text->setTabChangesFocus(true);
    m_withRecipe->setObjectName(QStringLiteral("reportRecipe"));
    m_withRecipe->setMinimumHeight(theme::kTarget);
    m_withRecipe->setToolTip(tr("All that was done to the tree, so that others can do it again."));
    connect(m_withRecipe, &QCheckBox::toggled, this, &ReportSheet::showText);

    auto* copyText = new QPushButton(tr("Copy"), this);
    copyText->setObjectName(QStringLiteral("reportCopy"));
    copyText->setDefault(true);
    connect(copyText, &QPushButton::clicked, this, &ReportSheet::copy);
    auto* close = new QPushButton(tr("Close"), this);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_withRecipe);
    buttons->addStretch(1);
    for (QPushButton* button : {copyText, close}) {
        button->setMinimumSize(110, theme::kTarget);
        buttons->addWidget(button);
    }
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(26, 20, 26, 20);
    all->setSpacing(14);
    all->addWidget(note);
    all->addWidget(m_text, 1);
    all->addLayout(buttons);
    showText();
}

QString ReportSheet::text() const
{
    return m_text->toPlainText();
}

void ReportSheet::showText()
{
    QString text = m_facts;
    if (m_withRecipe->isChecked())
        text += QStringLiteral("\n\nRecipe:\n") + m_recipe();
    m_text->setPlainText(text);
}

void ReportSheet::copy()
{
    QGuiApplication::clipboard()->setText(text());
}

} // namespace espalier
