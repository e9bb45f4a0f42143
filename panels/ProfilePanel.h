// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"
#include "panels/ProfileCanvas.h"

class QButtonGroup;
class QPushButton;

namespace espalier {

/// The cross-section of the chosen node, and what can be done with its profile (Strands 2024 §5.3).
class ProfilePanel : public Bar {
    Q_OBJECT

public:
    /// What is done with the nodes from the chosen one to another one of its branch.
    enum class Span { None, Copy, Blend };

    explicit ProfilePanel(QWidget* parent = nullptr);

    ProfileCanvas& canvas() { return *m_canvas; }
    /// Describes the chosen node: the radius of its wood, m, and the number of its strands.
    void describe(double radius, std::uint32_t strands, bool hasProfile);
    /// Shows that no node is chosen.
    void showNothing();
    /// Whether the profile may be changed now.
    void setMayEdit(bool may);
    /// Which of the two buttons waits for the other end of a branch.
    void setSpan(Span span);
    Span span() const { return m_span; }
    /// Shows a sentence below the section until the next stroke; empty for the usual advice.
    void tell(const QString& sentence, bool isFault);
    /// The sentence about a fault that is shown; empty if there is none.
    const QString& faultText() const { return m_faultText; }

Q_SIGNALS:
    void edited(const StrandProfile& profile);
    void clearAsked();
    /// The next node up or down the branch is wanted.
    void stepAsked(bool up);
    /// The user begins to choose the other end of a branch, or has chosen it with the buttons alone (None).
    void spanAsked(Span span);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addModes(class QVBoxLayout& column);
    void addShapes(QVBoxLayout& column);
    void addActions(QVBoxLayout& column);
    QPushButton* addButton(class QHBoxLayout& row, const char* name, const QString& text,
                           const QString& toolTip);
    void updateEnabled();
    /// What the user can do now.
    QString advice() const;

    ProfileCanvas* m_canvas;
    class QLabel* m_title;
    QLabel* m_message;
    QButtonGroup* m_modes;
    std::vector<QAbstractButton*> m_ofNode; ///< Need a node
    QPushButton* m_copy = nullptr;
    QPushButton* m_blend = nullptr;
    QPushButton* m_clear = nullptr;
    QString m_faultText;
    QString m_shapeName; ///< Of the ready-made shape that the user may be about to choose
    Span m_span = Span::None;
    bool m_hasNode = false;
    bool m_hasProfile = false;
    bool m_mayEdit = true;
};

} // namespace espalier
