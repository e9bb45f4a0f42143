// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QDialog>
#include <QImage>

#include <optional>
#include <vector>

class QPushButton;
class QScrollArea;

namespace espalier {

class RecoveryRow;

/// A tree that can be brought back, as the sheet shows it.
struct RecoverableTree {
    QString name;                   ///< Of its file, or what is said in its place
    QString place;                  ///< The file's folder; empty if the tree was never saved
    std::optional<QDateTime> saved; ///< When its file was written; none if there is no file
    QDateTime changed;              ///< When the last change was kept
};

/// The dialog that offers the trees which were not saved when the program ended: each with a picture of its
/// file and of what can be brought back, to compare them. Several can be discarded, which happens only once
/// the dialog has closed; one can be brought back, which closes it; what is left stays for later.
class RecoverySheet : public QDialog {
    Q_OBJECT

public:
    enum class State { Saved, Changed };

    /// Must have at least one tree.
    explicit RecoverySheet(const std::vector<RecoverableTree>& trees, QWidget* parent = nullptr);

    /// Shows what became known of a tree: @p caption says more about it. A null picture says that there is
    /// none.
    void showState(std::size_t tree, State state, const QImage& picture, const QString& caption);
    /// Size of the pictures, px.
    QSize pictureSize() const;
    /// The trees to discard, by their index, once the dialog has closed; none if it was cancelled.
    std::vector<std::size_t> discarded() const;
    /// The tree to bring back, once the dialog has closed.
    std::optional<std::size_t> broughtBack() const { return m_broughtBack; }

private:
    std::vector<std::size_t> marked() const;
    void showEnd();
    void fit();

    std::vector<RecoveryRow*> m_rows;
    std::optional<std::size_t> m_broughtBack;
    QPushButton* m_end;
    QScrollArea* m_scroll = nullptr;
};

} // namespace espalier
