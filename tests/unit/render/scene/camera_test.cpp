#include "render/scene/camera.h"

#include <QtTest>
#include <cmath>

using render::Camera;
using render::NamedView;

namespace {

constexpr float kAspect = 1.6F;
const glm::vec3 kMin{-50.0F, -30.0F, 0.0F};
const glm::vec3 kMax{50.0F, 30.0F, 1.6F};

/// Normalised device coordinates with y up.
glm::vec3 project(const Camera& camera, const glm::vec3& p) {
    const glm::vec4 clip = camera.projection(kAspect) * camera.view() * glm::vec4(p, 1.0F);
    return {clip.x / clip.w, -clip.y / clip.w, clip.z / clip.w};
}

}  // namespace

class CameraTest : public QObject {
    Q_OBJECT

private slots:
    void fittedBoardIsSeenWhole_data() {
        QTest::addColumn<int>("view");
        QTest::addColumn<bool>("isOrthographic");
        for (int view = 0; view < 3; ++view) {
            QTest::addRow("view %d, perspective", view) << view << false;
            QTest::addRow("view %d, orthographic", view) << view << true;
        }
    }
    void fittedBoardIsSeenWhole() {
        QFETCH(int, view);
        QFETCH(bool, isOrthographic);
        Camera camera;
        camera.setOrthographic(isOrthographic);
        camera.fit(kMin, kMax, static_cast<NamedView>(view), kAspect);
        float widest = 0.0F;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 p{(corner & 1) != 0 ? kMin.x : kMax.x, (corner & 2) != 0 ? kMin.y : kMax.y,
                              (corner & 4) != 0 ? kMin.z : kMax.z};
            const glm::vec3 seen = project(camera, p);
            widest = std::max({widest, std::abs(seen.x), std::abs(seen.y)});
            QVERIFY(seen.z > 0.0F && seen.z < 1.0F);
        }
        QVERIFY(widest <= 1.0F);
        QVERIFY2(widest > 0.9F, "the board fills the view");
    }

    void topShowsXRightAndYUp() {
        Camera camera;
        camera.fit(kMin, kMax, NamedView::Top, kAspect);
        QVERIFY(project(camera, {10, 0, 0}).x > 0.0F);
        QVERIFY(project(camera, {0, 10, 0}).y > 0.0F);
    }

    void bottomIsFlippedAboutTheVerticalAxis() {
        Camera camera;
        camera.fit(kMin, kMax, NamedView::Bottom, kAspect);
        QVERIFY(project(camera, {10, 0, 0}).x < 0.0F);
        QVERIFY(project(camera, {0, 10, 0}).y > 0.0F);
    }

    void nearerIsGreaterDepth() {
        Camera camera;
        camera.fit(kMin, kMax, NamedView::Top, kAspect);
        QVERIFY(project(camera, {0, 0, 1.6F}).z > project(camera, {0, 0, 0}).z);
        camera.setOrthographic(true);
        QVERIFY(project(camera, {0, 0, 1.6F}).z > project(camera, {0, 0, 0}).z);
    }

    void zoomKeepsThePointUnderTheCursor() {
        for (const bool isOrthographic : {false, true}) {
            Camera camera;
            camera.setOrthographic(isOrthographic);
            camera.fit(kMin, kMax, NamedView::Iso, kAspect);
            // A point of the plane through the target that faces the eye.
            const glm::mat3 toWorld = glm::transpose(glm::mat3(camera.view()));
            const glm::vec3 p = camera.target() + toWorld * glm::vec3(12.0F, 7.0F, 0.0F);
            const glm::vec3 before = project(camera, p);
            camera.zoom(3.0F, {before.x, before.y}, kAspect);
            const glm::vec3 after = project(camera, p);
            QVERIFY(std::abs(before.x - after.x) < 1e-3F && std::abs(before.y - after.y) < 1e-3F);
        }
    }

    void panMovesThePointWithTheCursor() {
        Camera camera;
        camera.fit(kMin, kMax, NamedView::Iso, kAspect);
        const glm::vec3 p = camera.target();
        const float height = 500.0F;
        camera.pan({40.0F, 25.0F}, height);
        const glm::vec3 seen = project(camera, p);
        QVERIFY(std::abs(seen.x - 40.0F / (height * kAspect / 2.0F)) < 1e-3F);
        QVERIFY(std::abs(seen.y + 25.0F / (height / 2.0F)) < 1e-3F);
    }

    void windowFillsTheViewExactly() {
        Camera camera;
        camera.fit(kMin, kMax, NamedView::Top, kAspect);
        camera.fitWindow({10.0F, 10.0F}, {26.0F, 20.0F}, 1.6F, kAspect);
        const glm::vec3 low = project(camera, {10.0F, 10.0F, 1.6F});
        const glm::vec3 high = project(camera, {26.0F, 20.0F, 0.0F});
        QVERIFY(glm::length(glm::vec2(low) - glm::vec2(-1.0F)) < 1e-4F);
        QVERIFY(glm::length(glm::vec2(high) - glm::vec2(1.0F)) < 1e-4F);
        camera.fitWindow({10.0F, 10.0F}, {26.0F, 20.0F}, 1.6F, kAspect, NamedView::Bottom);
        const glm::vec3 right = project(camera, {10.0F, 10.0F, 1.6F});  // as the board is flipped
        QVERIFY(glm::length(glm::vec2(right) - glm::vec2(1.0F, -1.0F)) < 1e-4F);
    }

    void orbitStopsAtThePoles() {
        Camera camera;
        camera.fit(kMin, kMax, NamedView::Top, kAspect);
        camera.orbit(0.0F, -3.0F);
        QVERIFY(std::abs(camera.direction().z + 1.0F) < 1e-5F);
        camera.orbit(0.0F, 10.0F);
        QVERIFY(std::abs(camera.direction().z - 1.0F) < 1e-5F);
    }

    void focusOnHeightKeepsThePictureAndPutsTheTargetThere() {
        Camera camera;
        camera.fit({-50.0F, -30.0F, 0.0F}, {50.0F, 30.0F, 1.6F}, NamedView::Iso, 1.5F);
        const glm::vec3 eye = camera.eye();
        camera.focusOnHeight(1.6F);
        QVERIFY(std::abs(camera.target().z - 1.6F) < 1e-3F);
        QVERIFY(glm::length(camera.eye() - eye) < 1e-2F);
    }
};

QTEST_APPLESS_MAIN(CameraTest)
#include "camera_test.moc"
