// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/ParameterGesture.h"

#include <QObject>
#include <QTimer>

#include <span>

namespace espalier {

/// The parameters that a panel shows of a document, and the way in which the user changes them: one gesture
/// at a time, and each gesture one undo step. Values that depend on each other stay consistent: the weights
/// of direction sum up to 1, the ellipse of gravimorphism contains the axis, and another shape of the leaves
/// brings its usual breadth.
class ParameterEditor : public QObject {
    Q_OBJECT

public:
    explicit ParameterEditor(TreeDocument& document, QObject* parent = nullptr);
    ~ParameterEditor() override { hold(false); }

    /// The parameters that controls show: the document's, or those of the gesture under way.
    const TreeParameters& shown() const { return m_shown; }
    const TreeParameters& inForce() const { return m_document.parameters(); }
    /// Value of a parameter, in ParameterInfo's surface unit.
    double value(const char* key) const;

    /// Begins a gesture, on a press, and ends the one under way.
    void begin();
    /// Shows other parameters, or another value of one, without putting them in force.
    void show(const TreeParameters& parameters);
    void show(const char* key, double value);
    /// Puts the shown parameters in force; the gesture can continue. @p text names the undo step.
    void putInForce(const QString& text);
    /// Puts the result of the gesture in force and ends it.
    void finish(const QString& text);
    /// Ends the gesture and restores the parameters from before it.
    void cancel();

    /// Applies a key press in the control @p by; key presses that follow each other closely are one gesture.
    void nudge(const QObject* by, const TreeParameters& parameters, const QString& text);
    void nudge(const QObject* by, const char* key, double value, const QString& text);
    /// Puts the program's defaults of @p keys in force as a part of the latest gesture, so that a double
    /// click also undoes the effect of its first click.
    void reset(std::span<const char* const> keys, const QString& text);

Q_SIGNALS:
    void shownChanged();
    /// Another part of the program has changed the document's parameters (undo, another panel): a drag under
    /// way has ended.
    void overtaken();

private:
    void hold(bool held);

    TreeDocument& m_document;
    ParameterGesture m_gesture;
    TreeParameters m_shown;
    bool m_isOwnChange = false;
    bool m_holds = false;                ///< See TreeDocument::holdParameters
    const QObject* m_nudgedBy = nullptr; ///< Only compared, never dereferenced
    QTimer m_rest;
};

/// The ellipse's offset stays within this part of its vertical axis: |e_v| <= 0.95 s_v.
inline constexpr double kMostEllipseOffset = 0.95;

/// Sets one parameter, in its surface unit, and corrects the parameters that then contradict it.
void setParameter(TreeParameters& parameters, const char* key, double value);

} // namespace espalier
