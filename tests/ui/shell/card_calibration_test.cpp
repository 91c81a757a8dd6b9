#include "ui/shell/card_calibration.h"

#include <QtTest>

#include "render/gpu/instance.h"
#include "tests/patience.h"

using namespace ui;
using render::MeasuredBackendsFile;

/// The software device of the tests, as if it were a card.
class CardCalibrationTest : public QObject {
    Q_OBJECT

    static render::gpu::Caps cardCaps() {
        const auto instance = render::gpu::Instance::create({});
        render::gpu::Caps caps = render::gpu::Device::create(*instance)->caps();
        caps.isCpu = false;
        return caps;
    }

    static render::Trial smallTrial() {
        render::Trial trial;
        trial.board = {{40, 4, 60, 20, 40}, 3};
        trial.width = 64;
        trial.height = 48;
        trial.rounds = 1;
        return trial;
    }

    MeasuredBackendsFile file() const { return {folder(), m_caps.cacheOwner}; }
    std::filesystem::path folder() const { return m_folder.path().toStdString(); }

    render::gpu::Caps m_caps;
    QTemporaryDir m_folder;

private slots:
    void initTestCase() { m_caps = cardCaps(); }
    void cleanup() { file().remove(); }

    void cardsAreMeasuredInTheBackground() {
        CardCalibration calibration(m_caps, folder(), smallTrial(), 0);
        QSignalSpy spy(&calibration, &CardCalibration::finished);
        QVERIFY(spy.wait(60'000));
        QVERIFY(file().load());
        QVERIFY(file().load()->plain != render::Backend::Auto);
    }

    void whatIsKnownIsNotMeasuredAgain() {
        QVERIFY(file().save({}));
        CardCalibration calibration(m_caps, folder(), smallTrial(), 0);
        QSignalSpy spy(&calibration, &CardCalibration::finished);
        QVERIFY(!spy.wait(200));
        QVERIFY(file().load() == render::MeasuredBackends{});
    }

    void softwareDevicesAreNotMeasured() {
        render::gpu::Caps caps = m_caps;
        caps.isCpu = true;
        CardCalibration calibration(caps, folder(), smallTrial(), 0);
        QTest::qWait(200);
        QVERIFY(!file().load());
    }

    void itEndsWithTheWindow() {
        {
            const CardCalibration calibration(m_caps, folder(), {}, 0);
            QTRY_VERIFY(file().load());  // it has begun
        }
        QVERIFY(!file().load());
    }
};

QTEST_MAIN(CardCalibrationTest)
#include "card_calibration_test.moc"
