// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/architecture/ArchitecturePanel.h"
#include "panels/architecture/Diagram.h"
#include "panels/architecture/DiagramHandle.h"

#include <QObject>

#include <memory>

class QPointingDevice;

namespace espalier::test {

/// The panel of architecture in its own window, with a new document for each test.
class ArchitectureFixture : public QObject {
    Q_OBJECT

protected Q_SLOTS:
    // QtTest calls these around the tests.
    void initTestCase();
    void init();
    void cleanup();

protected:
    /// Each handle, by its first parameter.
    static void handles();
    struct Place {
        Diagram* diagram;
        int number;
        DiagramHandle& handle() const { return diagram->handle(number); }
        QPoint point() const { return diagram->handlePlace(number).toPoint(); }
    };
    /// The handle of the current row of data.
    Place fetched() const;
    const TreeParameters& parameters() const { return m_document->parameters(); }
    int steps() const { return m_document->undoStack().count(); }
    void drag(const Place& place, const QPoint& by, bool letGo = true) const;
    /// A move that changes the parameter of any handle.
    static QPoint away(const Place& place);

    std::unique_ptr<TreeDocument> m_document;
    std::unique_ptr<ArchitecturePanel> m_panel;
    QPointingDevice* m_screen = nullptr;
};

} // namespace espalier::test
