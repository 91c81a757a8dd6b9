#include "render/calibration/calibrate.h"

#include <QtTest>

#include "model/text/whole_file.h"
#include "render/backends/backend_choice.h"
#include "render/calibration/trial_board.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;

/// Measuring on the device of the tests, small: that it takes what is fastest, not what that is.
class CalibrateTest : public QObject {
    Q_OBJECT

    static Trial smallTrial() {
        Trial trial;
        trial.board = {{40, 4, 60, 20, 40}, 3};
        trial.width = 64;
        trial.height = 48;
        trial.rounds = 1;
        trial.warmUpMs = 0.0;
        return trial;
    }

    static gpu::PipelineCacheOwner owner() { return test::Gpu::get().device.caps().cacheOwner; }

    MeasuredBackendsFile file(const gpu::PipelineCacheOwner& whose = owner()) const {
        return {m_folder.path().toStdString(), whose};
    }

    QTemporaryDir m_folder;

private slots:
    void cleanup() { QDir(m_folder.path()).removeRecursively(), QDir().mkpath(m_folder.path()); }

    void theFastestIsTakenWhereItIsWorthIt() {
        const auto taken = [](double pull, double mesh, double raster, Backend usual) {
            const CandidateTime times[] = {
                {Backend::Pull, false, pull}, {Backend::Mesh, false, mesh}, {Backend::Raster, false, raster}};
            return fastestOf(times, usual);
        };
        QCOMPARE(taken(10.0, 9.0, 8.6, Backend::Pull), Backend::Pull);
        QCOMPARE(taken(10.0, 9.0, 8.4, Backend::Pull), Backend::Raster);
        QCOMPARE(taken(10.0, 9.0, 8.4, Backend::Mesh), Backend::Mesh);
        QCOMPARE(taken(1.0, 9.0, 8.4, Backend::Raster), Backend::Pull);
        QCOMPARE(taken(3.0, 3.0, 3.0, Backend::Raster), Backend::Raster);
    }

    void trialBoardsHaveTheirElements() {
        base::Progress progress;
        const auto board = makeTrialBoard(smallTrial().board, progress);
        QVERIFY(board);
        QVERIFY(board->model.elementCount >= 40 + 4 + 60 + 20 + 40);
        QVERIFY(board->model.diagnostics.entries().empty());
        QCOMPARE(board->styles.size(), board->model.layers.size());
    }

    void everyBackEndIsMeasured() {
        base::Progress progress;
        gpu::Device& device = test::Gpu::get().device;
        const auto measured = calibrate(device, smallTrial(), progress);
        QVERIFY2(measured, measured ? "" : measured.error().text.c_str());
        for (const bool isSmoothed : {false, true}) {
            const auto isTaken = [&](const CandidateTime& time) {
                return time.isSmoothed == isSmoothed && time.isTaken;
            };
            const auto taken = std::ranges::find_if(measured->times, isTaken);
            QCOMPARE(taken == measured->times.end() ? Backend::Auto : taken->backend, measured->fastest.of(isSmoothed));
            QVERIFY(std::ranges::count_if(measured->times, isTaken) <= 1);
        }
        QCOMPARE(measured->times.size(),
                 tiltedBackends(device.caps(), false).size() +
                     (device.caps().canSmooth ? tiltedBackends(device.caps(), true).size() : 0));
        QVERIFY(measured->fastest.plain != Backend::Auto);
        QCOMPARE(measured->fastest.smoothed != Backend::Auto, device.caps().canSmooth);
        QVERIFY(std::ranges::all_of(measured->times, [](const CandidateTime& time) { return time.ms > 0.0; }));
    }

    void lostDevicesAreAnError() {
        auto device = gpu::Device::create(test::Gpu::get().instance);
        QVERIFY(device);
        device->inject({.loseAtSubmission = 3});
        base::Progress progress;
        const auto measured = calibrate(*device, smallTrial(), progress);
        QVERIFY(!measured);
        QCOMPARE(measured.error().code, base::ErrorCode::DeviceFailed);
    }

    void devicesWithoutRoomAreAnError() {
        auto device = gpu::Device::create(test::Gpu::get().instance);
        QVERIFY(device);
        device->inject({.failAllocation = 1, .failsFromThere = true});
        base::Progress progress;
        const auto measured = calibrate(*device, smallTrial(), progress);
        QVERIFY(!measured);
        QCOMPARE(measured.error().code, base::ErrorCode::DeviceFailed);
    }

    void itIsMeasuredOnce() {
        base::Progress progress;
        QVERIFY(calibrateOnce(file(), owner(), smallTrial(), progress));
        QVERIFY(file().load());
        QVERIFY(file().load()->plain != Backend::Auto);
        const MeasuredBackends other{Backend::Mesh, Backend::Auto};
        QVERIFY(file().save(other));
        QVERIFY(calibrateOnce(file(), owner(), smallTrial(), progress));
        QVERIFY(file().load() == other);
    }

    void cancelledItIsAsIfItHadNotBegun() {
        base::Progress progress;
        progress.cancel();
        const base::Status status = calibrateOnce(file(), owner(), smallTrial(), progress);
        QVERIFY(!status);
        QCOMPARE(status.error().code, base::ErrorCode::Cancelled);
        QVERIFY(QDir(m_folder.path()).isEmpty());
    }

    void anotherDeviceIsNotMeasuredInstead() {
        gpu::PipelineCacheOwner other = owner();
        other.device ^= 1;
        base::Progress progress;
        QVERIFY(calibrateOnce(file(other), other, smallTrial(), progress));
        QVERIFY(file(other).load() == MeasuredBackends{});
    }

    void whatCannotBeSavedIsNotMeasured() {
        const std::string taken = m_folder.path().toStdString() + "/taken";
        QVERIFY(model::writeWholeFile(taken, "a file"));
        base::Progress progress;
        const base::Status status = calibrateOnce({taken, owner()}, owner(), smallTrial(), progress);
        QVERIFY(!status);
        QCOMPARE(status.error().code, base::ErrorCode::OutputFailed);
        QVERIFY(progress.phase().empty());
    }
};

GPU_TEST_MAIN(CalibrateTest)
#include "calibrate_test.moc"
