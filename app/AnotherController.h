// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "panels/AnotherPanel.h"

#include <QObject>

#include <array>
#include <functional>
#include <memory>

namespace espalier {

class Notice;
class OffscreenRenderer;
class ViewSettings;
class Viewport;
struct PreparedTree;

/// Shows trees that the user's own gestures make with other seeds, and takes one of them in place of the
/// document's. A worker thread replays the gestures from a snapshot, one tree after another.
class AnotherController : public QObject {
    Q_OBJECT

public:
    /// The parts of the program that it needs. All of them outlive it.
    struct Parts {
        TreeDocument& document;
        const ViewSettings& settings;
        Viewport& viewport;
        AnotherPanel& panel;
        Notice& notice;
        std::function<bool()> isBusy;
        /// Shows or hides the panel.
        std::function<void(bool shown)> show;
    };
    explicit AnotherController(Parts parts);
    /// Stops the work.
    ~AnotherController() override;

    /// Opens the panel and begins to grow the trees; closes it if it is open.
    void toggle();
    /// Stops the work and closes the panel. Returns false if it was closed.
    bool close();
    bool isOpen() const { return m_job != nullptr; }
    /// The number of trees that have been grown and shown.
    int grownCount() const { return m_grown; }

private:
    struct Job;
    struct Grown;

    void begin();
    void growNext();
    void receive(Grown grown);
    QImage pictureOf(Grown& grown);
    void take(int number);

    Parts m_parts;
    std::shared_ptr<Job> m_job; ///< Null while the panel is closed
    int m_first = 0;            ///< Number of the first tree that is shown
    int m_grown = 0;
    std::array<std::unique_ptr<PreparedTree>, AnotherPanel::kCount> m_trees;
    std::unique_ptr<OffscreenRenderer> m_renderer; ///< Null until it is needed
};

} // namespace espalier
