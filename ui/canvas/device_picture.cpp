#include "ui/canvas/device_picture.h"

#include <chrono>
#include <functional>
#include <utility>

#include "model/base/background.h"

namespace ui {

namespace {

constexpr int kLookMs = 2;
/// A picture that is done within this time is shown at once.
constexpr std::uint64_t kPatienceNs = 6'000'000;
/// Another picture may be wanted once what one needs is made; but what cannot be made is not tried for ever.
constexpr int kMostPreparations = 4;

}  // namespace

DevicePicture::DevicePicture(GpuContext& context, const Picture& picture, QObject* parent)
    : QObject(parent), m_context(context), m_picture(picture) {
    m_look.setTimerType(Qt::PreciseTimer);
    m_look.setInterval(kLookMs);
    connect(&m_look, &QTimer::timeout, this, [this] {
        if (m_isDrawing ? takeIfDone(0) : begin()) {
            emit done();
        }
    });
    connect(&context.turns(), &DeviceTurns::came, this, [this](QObject* user) {
        if (user == this && begin()) {
            emit done();
        }
    });
}

DevicePicture::~DevicePicture() {
    release();
}

/// Making its pipelines takes longer than drawing.
void DevicePicture::makeReady() {
    if (m_presenter || m_context.device().isLost()) {
        return;
    }
    m_presenter.emplace(m_context.device());
    m_preparing = std::async(std::launch::async, [this] {
        base::becomeBackground();
        m_presenter->makeReady(render::Backend::Auto, true);
        m_presenter->makeReady(render::Backend::Auto, false);
    });
}

void DevicePicture::clear() {
    m_wanted.reset();
    m_shot = {};
    m_whole = {};
    m_isOfBefore = m_isDrawing;
    if (!m_isDrawing) {
        stop();
    }
}

void DevicePicture::release() {
    clear();
    if (m_preparing.valid()) {
        m_preparing.wait();
    }
    m_presenter.reset();
    stop();
}

/// Gives way to others.
void DevicePicture::stop() {
    m_isDrawing = m_isOfBefore = false;
    m_look.stop();
    m_context.turns().end(*this);
}

bool DevicePicture::request(const render::Camera& camera, QSize pixels, bool isBoardSame) {
    // The device keeps the board of the last picture only.
    const bool isKept = m_wanted ? m_wanted->isBoardSame : !m_drawn.isWhole;
    m_wanted = Wanted{camera, pixels, isBoardSame && isKept};
    return !m_look.isActive() && m_context.turns().begin(*this) && begin();
}

void DevicePicture::requestWhole(const render::Camera& camera, QSize pixels) {
    if (isUnderWay()) {
        return;
    }
    m_wanted = Wanted{camera, pixels, false, true};
    if (m_context.turns().begin(*this)) {
        (void)begin();
    }
}

render::ViewSettings DevicePicture::settingsOf(const Wanted& wanted) const {
    render::ViewSettings settings = m_picture.frameSettings();
    settings.overlay = {};
    if (wanted.isWhole) {
        settings.inPlane = {};  // is painted for the camera of the view
        settings.levels = render::LevelOfDetail::Coarse;
    }
    settings.cachesBoard = settings.inPlane.pixels.rgba != nullptr;
    settings.isBoardCached = wanted.isBoardSame;
    return settings;
}

/// Else what it lacks is made in the background: pipelines of the first pictures, of a back end or smoothing just
/// chosen or for a section plane, and images of another size.
bool DevicePicture::isPrepared() {
    if (m_preparing.valid() && m_preparing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return false;
    }
    const std::function<void()> prepare = m_presenter->preparation(
        *m_picture.scene, m_wanted->camera, settingsOf(*m_wanted), static_cast<std::uint32_t>(m_wanted->pixels.width()),
        static_cast<std::uint32_t>(m_wanted->pixels.height()));
    const int times = m_prepared.pixels == m_wanted->pixels ? m_prepared.times : 0;
    if (!prepare || times == kMostPreparations) {
        m_prepared = {};
        return true;
    }
    m_prepared = {m_wanted->pixels, times + 1};
    m_preparing = std::async(std::launch::async, [prepare] {
        base::becomeBackground();
        prepare();
    });
    return false;
}

/// True: it is done already.
bool DevicePicture::begin() {
    if (!m_wanted || m_picture.scene == nullptr) {
        stop();
        return false;
    }
    makeReady();
    if (!isPrepared()) {
        m_look.start();
        return false;
    }
    m_drawn = *std::exchange(m_wanted, std::nullopt);
    const base::Status status = m_presenter->begin(*m_picture.scene, m_drawn.camera, settingsOf(m_drawn),
                                                   static_cast<std::uint32_t>(m_drawn.pixels.width()),
                                                   static_cast<std::uint32_t>(m_drawn.pixels.height()));
    if (status) {
        m_isDrawing = true;
        m_look.start();
        return takeIfDone(kPatienceNs);
    }
    stop();
    if (status.error().code == base::ErrorCode::DeviceFailed) {
        m_context.device().markLost();  // or it has no memory left: a device made anew may have
        emit deviceLost();
    }
    return false;
}

bool DevicePicture::takeIfDone(std::uint64_t patienceNs) {
    if (!m_presenter->isDone(patienceNs)) {
        if (m_context.device().isLost()) {
            stop();
            emit deviceLost();
        }
        return false;
    }
    const bool isOfBefore = m_isOfBefore;
    stop();
    if (!isOfBefore) {
        keep();
    }
    const bool isShown = !isOfBefore && !m_drawn.isWhole;
    const bool isNextThere = m_wanted && m_context.turns().begin(*this) && begin();
    return isShown || isNextThere;
}

void DevicePicture::keep() {
    Shot& shot = m_drawn.isWhole ? m_whole : m_shot;
    if (shot.image.size() != m_drawn.pixels || !shot.image.isDetached()) {
        shot.image = QImage(m_drawn.pixels, QImage::Format_RGB32);  // others may go on with the one of before
    }
    // Rows of 32-bit pixels lie one after the other.
    m_presenter->take(
        {reinterpret_cast<std::uint32_t*>(shot.image.bits()),
         static_cast<std::size_t>(m_drawn.pixels.width()) * static_cast<std::size_t>(m_drawn.pixels.height())});
    shot.camera = m_drawn.camera;
    shot.stats = m_presenter->stats();
}

}  // namespace ui
