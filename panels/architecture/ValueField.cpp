// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/ValueField.h"

#include "panels/ParameterEditor.h"
#include "panels/ParameterNumber.h"
#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>

namespace espalier {

ValueField::ValueField(ParameterEditor& editor, const char* key, QWidget* parent)
    : QWidget(parent), m_editor(editor), m_key(key)
{
    const ParameterScale scale = ParameterScale::of(key);
    m_number = new ParameterNumber(scale, this);
    m_number->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_number->setAccessibleDescription(parameterTr(scale.text().tip));
    m_number->setFixedHeight(theme::kTarget);

    QString symbol = QString::fromUtf8(scale.text().symbol);
    if (const auto underscore = symbol.indexOf(QLatin1Char('_')); underscore > 0)
        symbol = QStringLiteral("%1<sub>%2</sub>").arg(symbol.left(underscore), symbol.mid(underscore + 1));
    auto* label = new QLabel(symbol, this);
    label->setTextFormat(Qt::RichText);
    label->setBuddy(m_number);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    theme::setTone(*label, theme::Tone::Dim);

    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(2);
    line->addWidget(label);
    line->addWidget(m_number);
    line->addStretch(1);
    setMinimumWidth(theme::kTarget);
    setFixedHeight(theme::kTarget);
    setToolTip(explanation(scale.text()));
    setWhatsThis(toolTip());

    const auto follow = [this] { m_number->show(m_editor.value(m_key)); };
    follow();
    connect(&editor, &ParameterEditor::shownChanged, this, follow);
    connect(m_number, &ParameterNumber::edited, this,
            [this](double value) { m_editor.nudge(this, m_key, value, m_number->accessibleName()); });
}

void ValueField::mousePressEvent(QMouseEvent* event)
{
    m_editor.begin();
    // A tap on the symbol edits the number too.
    m_number->setFocus(Qt::MouseFocusReason);
    event->accept();
}

void ValueField::mouseDoubleClickEvent(QMouseEvent*)
{
    const char* const keys[] = {m_key};
    m_editor.reset(keys, m_number->accessibleName());
}

} // namespace espalier
