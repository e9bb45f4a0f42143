// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/DiagramHandle.h"

#include "panels/AccessibleParameter.h"

#include <QAccessible>
#include <QKeyEvent>

namespace espalier {

namespace {

QAccessibleInterface* makeAccessibleHandle(const QString&, QObject* object)
{
    auto* handle = qobject_cast<DiagramHandle*>(object);
    if (!handle)
        return nullptr;
    return new AccessibleParameter(handle, {handle->scale(), [handle] { return handle->value(); },
                                            [handle](double value) { handle->setValue(value); },
                                            [handle] { return handle->valueText(); }});
}

} // namespace

DiagramHandle::DiagramHandle(QWidget& parent, Owner& owner, int number, std::vector<const char*> keys,
                             const QString& name)
    : QWidget(&parent), m_owner(owner), m_number(number), m_keys(std::move(keys))
{
    [[maybe_unused]] static const bool isKnown = [] {
        QAccessible::installFactory(makeAccessibleHandle);
        return true;
    }();
    QStringList explanations;
    QStringList tips;
    for (const char* key : m_keys) {
        m_scales.push_back(ParameterScale::of(key));
        explanations.append(explanation(m_scales.back().text()));
        tips.append(parameterTr(m_scales.back().text().tip));
    }
    setObjectName(QString::fromLatin1(m_keys.front()));
    setAccessibleName(name);
    setAccessibleDescription(tips.join(QLatin1Char(' ')));
    setToolTip(explanations.join(QStringLiteral("<br>")));
    setWhatsThis(toolTip());
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

double DiagramHandle::value() const
{
    return m_owner.valueOf(m_keys.front());
}

void DiagramHandle::setValue(double value)
{
    m_owner.setValueOf(*this, m_keys.front(), scale().rounded(value));
}

QString DiagramHandle::valueText() const
{
    QStringList parts;
    for (const ParameterScale& scale : m_scales) {
        const QString shown = scale.shown(m_owner.valueOf(scale.info().key));
        parts.append(m_scales.size() == 1
                         ? shown
                         : QStringLiteral("%1 %2").arg(parameterTr(scale.text().label), shown));
    }
    return parts.join(QStringLiteral(", "));
}

void DiagramHandle::announce()
{
    if (!QAccessible::isActive() || valueText() == m_announced)
        return;
    m_announced = valueText();
    QAccessibleValueChangeEvent event(this, value());
    QAccessible::updateAccessibility(&event);
}

bool DiagramHandle::event(QEvent* event)
{
    // These keys belong to the handle that has the focus, also if they have a meaning for the tree.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isEscape = key->key() == Qt::Key_Escape && m_owner.isDragging();
        const bool isPlain = !(key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
        if (isEscape ||
            (isPlain && (key->key() == Qt::Key_Delete || scale().keyed(value(), key->key(), {})))) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void DiagramHandle::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && m_owner.isDragging()) {
        m_owner.drop();
        return;
    }
    if (event->key() == Qt::Key_Delete) {
        m_owner.resetHandle(*this);
        return;
    }
    QPointF direction;
    switch (event->key()) {
    case Qt::Key_Left:
        direction = {-1.0, 0.0};
        break;
    case Qt::Key_Right:
        direction = {1.0, 0.0};
        break;
    case Qt::Key_Up:
        direction = {0.0, -1.0};
        break;
    case Qt::Key_Down:
        direction = {0.0, 1.0};
        break;
    default:
        if (const auto next = scale().keyed(value(), event->key(), event->modifiers()))
            setValue(*next);
        else
            QWidget::keyPressEvent(event);
        return;
    }
    const auto stride = event->modifiers() & Qt::ShiftModifier ? ParameterScale::Stride::Fine
                                                               : ParameterScale::Stride::Normal;
    m_owner.moveHandle(*this, direction, stride);
}

void DiagramHandle::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    parentWidget()->update();
}

void DiagramHandle::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    parentWidget()->update();
}

} // namespace espalier
