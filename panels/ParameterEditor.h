// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/ParameterGesture.h"

#include <QObject>
#include <QTimer>

#include <span>

namespace espalier {

/// What a panel shows of a document's parameters, and the way in which a person changes them: one gesture at
/// a time, and each gesture one undo step. Values that belong together stay so: the weights of direction
/// share a whole, the ellipse of gravimorphism contains the axis.
class ParameterEditor : public QObject {
    Q_OBJECT

public:
    explicit ParameterEditor(TreeDocument& document, QObject* parent = nullptr);
    ~ParameterEditor() override { hold(false); }

    /// What controls are to show: the document's parameters, or those of the gesture that goes on.
    const TreeParameters& shown() const { return m_shown; }
    const TreeParameters& inForce() const { return m_document.parameters(); }
    /// In ParameterInfo's surface unit.
    double value(const char* key) const;

    /// A gesture begins: a press. Any that went on is over.
    void begin();
    /// Shows other parameters, or another value of one, without putting them in force.
    void show(const TreeParameters& parameters);
    void show(const char* key, double value);
    /// Puts what is shown in force; the gesture may go on. @p text names the undo step.
    void putInForce(const QString& text);
    /// Puts in force what the gesture has come to.
    void finish(const QString& text);
    /// Takes the gesture back.
    void cancel();

    /// A stride of a key of the control @p by; those that follow each other closely are one gesture.
    void nudge(const QObject* by, const TreeParameters& parameters, const QString& text);
    void nudge(const QObject* by, const char* key, double value, const QString& text);
    /// Puts the program's defaults of @p keys in force, as a part of the gesture that last began: a double
    /// click leaves nothing of what its first click did.
    void reset(std::span<const char* const> keys, const QString& text);

Q_SIGNALS:
    void shownChanged();
    /// Somebody else has changed the document's parameters (undo, another panel): a drag that goes on is
    /// over.
    void overtaken();

private:
    void hold(bool held);

    TreeDocument& m_document;
    ParameterGesture m_gesture;
    TreeParameters m_shown;
    bool m_isOwnChange = false;
    bool m_holds = false;                ///< See TreeDocument::holdParameters
    const QObject* m_nudgedBy = nullptr; ///< Compared, never followed
    QTimer m_rest;
};

/// The ellipse's offset stays within this part of its vertical axis: |e_v| <= 0.95 s_v.
inline constexpr double kMostEllipseOffset = 0.95;

/// Sets one parameter, in its surface unit, and mends what contradicts it then.
void setParameter(TreeParameters& parameters, const char* key, double value);

} // namespace espalier
