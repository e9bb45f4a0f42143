// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/MainWindow.h"

#include <QMessageBox>
#include <QTemporaryDir>

#include <memory>

class QPointingDevice;

namespace espalier::test {

/// The user at the real window: events enter where the system's events do. The tests of a class share the
/// window, because it takes long to appear where the processor draws it; each test begins with a seedling and
/// the Brush tool.
class WindowFixture : public QObject {
    Q_OBJECT

public:
    /// @p size of the window, px.
    explicit WindowFixture(const QSize& size = {960, 640}) : m_size(size) {}

protected Q_SLOTS:
    // QtTest calls these around the tests.
    void initTestCase();
    void init();
    void cleanup();
    void cleanupTestCase() { m_window.reset(); }

protected:
    Workspace& workspace() { return m_window->workspace(); }
    Viewport& viewport() { return workspace().viewport(); }
    QWindow* handle() { return m_window->windowHandle(); }
    QAction* action(ActionId id) { return m_window->actions()[id]; }
    /// A point of the window, @p up metres above the tree's base and @p right metres to the right of it.
    QPoint at(float right, float up);
    /// Draws an upright stroke with the mouse.
    void brush(float fromUp = 0.0F, float toUp = 1.6F, float right = 0.0F);
    /// Makes a tree of a trunk, 1.6 m high, and 24 branches at once. That of a stroke of the brush depends on
    /// how fast the window takes the stroke.
    void makeTree();
    QString notice();
    /// Presses a button of the next message box.
    void answer(QMessageBox::StandardButton button);
    void save(const QString& fileName);

    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<QTemporaryDir> m_folder;
    QPointingDevice* m_screen;

private:
    QSize m_size;
};

} // namespace espalier::test
