// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/panels/ArchitectureFixture.h"

#include "panels/Theme.h"

#include <QApplication>
#include <QPoint>
#include <QTest>

namespace espalier::test {

void ArchitectureFixture::initTestCase()
{
    m_screen = QTest::createTouchDevice();
    theme::apply(*qApp);
}

void ArchitectureFixture::init()
{
    m_document = std::make_unique<TreeDocument>();
    m_panel = std::make_unique<ArchitecturePanel>(*m_document);
    m_panel->fit({1500, 1000});
    m_panel->show();
    m_panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
}

void ArchitectureFixture::cleanup()
{
    m_panel.reset();
    m_document.reset();
}

void ArchitectureFixture::handles()
{
    QTest::addColumn<QString>("key");
    for (const char* key :
         {"growth.setPointAngle", "growth.ellipseVertical", "growth.ellipseParallel", "growth.ellipseOffset",
          "growth.branchingAngle", "growth.deflectionAngle", "growth.axisWeight", "growth.occupancyRadius",
          "growth.perceptionDepth", "growth.perceptionAngle"})
        QTest::newRow(key) << QString::fromLatin1(key);
}

ArchitectureFixture::Place ArchitectureFixture::fetched() const
{
    QFETCH(QString, key);
    for (Diagram* diagram : m_panel->diagrams()) {
        for (int i = 0; i < diagram->handleCount(); ++i) {
            if (diagram->handle(i).keys().front() == key)
                return {diagram, i};
        }
    }
    qFatal("no handle for that parameter");
}

QPoint ArchitectureFixture::away(const Place& place)
{
    const QString key = place.handle().objectName();
    if (key == QStringLiteral("growth.ellipseParallel"))
        return {-18, 4};
    if (key == QStringLiteral("growth.ellipseOffset") || key == QStringLiteral("growth.perceptionDepth"))
        return {0, 14};
    if (key == QStringLiteral("growth.setPointAngle"))
        return {6, 18};
    return {-12, 16};
}

void ArchitectureFixture::drag(const Place& place, const QPoint& by, bool letGo) const
{
    const QPoint from = place.point();
    QTest::mousePress(place.diagram, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(place.diagram, from + by * i / 5);
    if (letGo)
        QTest::mouseRelease(place.diagram, Qt::LeftButton, {}, from + by);
}

} // namespace espalier::test
