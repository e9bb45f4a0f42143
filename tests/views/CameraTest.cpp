// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/TestClasses.h"
#include "views/camera/CameraFlight.h"

#include <QTest>

#include <array>

using namespace espalier;

namespace {

bool isNear(const Vec3& a, const Vec3& b, float tolerance = 1e-4F)
{
    return (a - b).norm() <= tolerance;
}

bool isNear(const QPointF& a, const QPointF& b, double tolerance = 1e-2)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y()) <= tolerance;
}

/// The place of a point by the camera's matrices, px.
QPointF projectedByMatrices(const Camera& camera, const Vec3& point)
{
    const Eigen::Vector4f clip =
        camera.projectionMatrix(0.1F, 100.0F) * camera.viewMatrix() * point.homogeneous();
    return {camera.viewSize().width() * static_cast<double>(0.5F + 0.5F * clip.x() / clip.w()),
            camera.viewSize().height() * static_cast<double>(0.5F - 0.5F * clip.y() / clip.w())};
}

Camera tiltedCamera()
{
    Camera camera;
    camera.setViewSize({1000, 600});
    camera.setTarget({0.3F, 2.0F, -0.5F});
    camera.setDistance(7.0F);
    camera.setAzimuth(0.7F);
    camera.setElevation(0.4F);
    camera.setTargetShare({0.4, 0.55});
    return camera;
}

} // namespace

class CameraTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void default_showsSixMetresWithTheSeedlingInTheLowerThird();
    void axes_areOrthonormalAndLevel();
    void project_agreesWithTheMatrices();
    void project_givesNothingBehindTheCamera();
    void ray_goesThroughWhatIsProjectedThere();
    void onPlane_isUnderThePointerAndAtTheDepthAskedFor();
    void orbit_keepsTheTargetAndStopsAtThePole();
    void pan_movesTheTargetWithThePointer();
    void zoom_keepsWhatIsUnderThePointer();
    void zoom_stopsAtTheLimits();
    void framing_showsAllCornersAndFillsTheView_data();
    void framing_showsAllCornersAndFillsTheView();
    void framing_ofNothingChangesNothing();
    void turnedTo_looksFromTheNamedSides();
    void flight_arrivesExactlyByTheShortWay();
};

void CameraTest::default_showsSixMetresWithTheSeedlingInTheLowerThird()
{
    const Camera camera;
    const QPointF base = *camera.project(Vec3::Zero());
    const QPointF above = *camera.project({0.0F, 4.5F, 0.0F});
    const double height = camera.viewSize().height();
    QVERIFY(isNear(above, {camera.viewSize().width() / 2.0, 0.0}, 0.5));
    QVERIFY(base.y() > 2.0 / 3.0 * height);
    QVERIFY(base.y() < 0.9 * height);
    // A stroke straight up must not lean toward the camera or away from it.
    const Vec3 top = camera.onPlane({base.x(), 10.0}, Vec3::Zero());
    QVERIFY(std::abs(top.z()) < 1e-4F);
    QVERIFY(std::abs(top.x()) < 1e-4F);
}

void CameraTest::axes_areOrthonormalAndLevel()
{
    const Camera camera = tiltedCamera();
    Eigen::Matrix3f axes;
    axes << camera.right(), camera.up(), -camera.forward();
    QVERIFY((axes.transpose() * axes - Eigen::Matrix3f::Identity()).norm() < 1e-5F);
    QVERIFY(std::abs(axes.determinant() - 1.0F) < 1e-5F);
    QCOMPARE(camera.right().y(), 0.0F);
    QVERIFY(camera.position().y() > camera.target().y());
}

void CameraTest::project_agreesWithTheMatrices()
{
    const Camera camera = tiltedCamera();
    for (const Vec3& point : {Vec3(0.0F, 0.0F, 0.0F), Vec3(1.0F, 3.0F, -2.0F), Vec3(-2.0F, 1.0F, 1.0F)})
        QVERIFY(isNear(*camera.project(point), projectedByMatrices(camera, point)));
    QVERIFY(isNear(*camera.project(camera.target()), {400, 330}));
}

void CameraTest::project_givesNothingBehindTheCamera()
{
    const Camera camera = tiltedCamera();
    QVERIFY(!camera.project(camera.position() - camera.forward()));
    QVERIFY(!camera.project(camera.position()));
}

void CameraTest::ray_goesThroughWhatIsProjectedThere()
{
    const Camera camera = tiltedCamera();
    const Ray ray = camera.ray({123, 456});
    QVERIFY(std::abs(ray.direction.norm() - 1.0F) < 1e-5F);
    QVERIFY(isNear(*camera.project(ray.origin + 5.0F * ray.direction), {123, 456}));
}

void CameraTest::onPlane_isUnderThePointerAndAtTheDepthAskedFor()
{
    const Camera camera = tiltedCamera();
    const Vec3 through(1.0F, 0.5F, 0.2F);
    const Vec3 point = camera.onPlane({777, 88}, through);
    QVERIFY(isNear(*camera.project(point), {777, 88}));
    QVERIFY(std::abs(camera.depth(point) - camera.depth(through)) < 1e-4F);
    const Vec3 fallback = camera.onPlane({777, 88}, camera.position() - camera.forward());
    QVERIFY(std::abs(camera.depth(fallback) - camera.distance()) < 1e-4F);
}

void CameraTest::orbit_keepsTheTargetAndStopsAtThePole()
{
    Camera camera = tiltedCamera();
    const Vec3 target = camera.target();
    camera.orbit(1.0F, 0.3F);
    QVERIFY(isNear(*camera.project(target), {400, 330}));
    QCOMPARE(camera.azimuth(), 1.7F);
    camera.orbit(0.0F, 10.0F);
    QCOMPARE(camera.elevation(), Camera::kMaxElevation);
    QVERIFY(isNear(camera.forward(), -up()));
    QVERIFY(std::abs(camera.up().norm() - 1.0F) < 1e-5F);
}

void CameraTest::pan_movesTheTargetWithThePointer()
{
    Camera camera = tiltedCamera();
    const Vec3 target = camera.target();
    camera.pan({40, -25});
    QVERIFY(isNear(*camera.project(target), {440, 305}));
}

void CameraTest::zoom_keepsWhatIsUnderThePointer()
{
    Camera camera = tiltedCamera();
    const Vec3 under = camera.onPlane({200, 500}, camera.target());
    camera.zoom(0.5F, {200, 500});
    QCOMPARE(camera.distance(), 3.5F);
    QVERIFY(isNear(*camera.project(under), {200, 500}));
}

void CameraTest::zoom_stopsAtTheLimits()
{
    Camera camera = tiltedCamera();
    camera.zoom(1e-9F, {400, 330});
    QCOMPARE(camera.distance(), Camera::kMinDistance);
    camera.zoom(1e9F, {400, 330});
    QCOMPARE(camera.distance(), Camera::kMaxDistance);
}

void CameraTest::framing_showsAllCornersAndFillsTheView_data()
{
    QTest::addColumn<QSizeF>("size");
    QTest::newRow("landscape") << QSizeF(1400, 600);
    QTest::newRow("portrait") << QSizeF(500, 1100);
}

void CameraTest::framing_showsAllCornersAndFillsTheView()
{
    QFETCH(QSizeF, size);
    Camera camera = tiltedCamera();
    camera.setViewSize(size);
    const Box3 box(Vec3(-2.0F, 0.0F, -1.0F), Vec3(3.0F, 6.0F, 2.0F));
    const Camera framed = camera.framing(box);
    QCOMPARE(framed.azimuth(), camera.azimuth());
    double widest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto seen = framed.project(box.corner(static_cast<Box3::CornerType>(corner)));
        QVERIFY(seen);
        QVERIFY(QRectF(QPointF(), size).contains(*seen));
        widest = std::max(
            {widest, std::abs(seen->x() / size.width() - 0.5), std::abs(seen->y() / size.height() - 0.5)});
    }
    QVERIFY(widest > 0.4);
}

void CameraTest::framing_ofNothingChangesNothing()
{
    QCOMPARE(tiltedCamera().framing(Box3()), tiltedCamera());
}

void CameraTest::turnedTo_looksFromTheNamedSides()
{
    const Camera camera = tiltedCamera();
    QVERIFY(isNear(camera.turnedTo(NamedView::Front).forward(), -Vec3::UnitZ()));
    QVERIFY(isNear(camera.turnedTo(NamedView::Side).forward(), -Vec3::UnitX()));
    QVERIFY(isNear(camera.turnedTo(NamedView::Top).forward(), -Vec3::UnitY()));
    const Vec3 oblique = camera.turnedTo(NamedView::ThreeQuarter).forward();
    QVERIFY(oblique.x() > 0.0F && oblique.y() < 0.0F && oblique.z() < 0.0F);
}

void CameraTest::flight_arrivesExactlyByTheShortWay()
{
    Camera from = tiltedCamera();
    from.setAzimuth(static_cast<float>(radians(350)));
    Camera to = tiltedCamera();
    to.setAzimuth(static_cast<float>(radians(10)));
    to.setDistance(20.0F);
    to.setTarget({1.0F, 2.0F, 3.0F});
    CameraFlight flight;
    QVERIFY(!flight.isFlying());
    flight.start(from, to);
    Camera camera = from;
    flight.advance(camera, CameraFlight::kDuration / 2.0);
    QVERIFY(flight.isFlying());
    QVERIFY(std::abs(degrees(camera.azimuth()) - 360.0) < 0.01);
    QVERIFY(camera.distance() > from.distance() && camera.distance() < to.distance());
    flight.advance(camera, CameraFlight::kDuration);
    QVERIFY(!flight.isFlying());
    QVERIFY(std::abs(degrees(camera.azimuth()) - 370.0) < 0.01);
    QVERIFY(isNear(camera.target(), to.target()));
    QVERIFY(std::abs(camera.distance() - 20.0F) < 1e-4F);
}

static const test::TestClass<CameraTest> cameraTest;

#include "CameraTest.moc"
