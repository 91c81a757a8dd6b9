#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "ui/canvas/camera_controller.h"

namespace ui {

/// Where a view has looked, as a browser knows where one has been: a location counts once the view has rested there.
/// Going back and then moving elsewhere drops what was ahead. Whether the view is in parallel is no part of where it
/// is, and stays as it is now.
class ViewHistory : public QObject {
    Q_OBJECT

public:
    static constexpr int kRestMs = 400;
    static constexpr std::size_t kMost = 100;

    explicit ViewHistory(CameraController& controller, QObject* parent = nullptr);

    /// Another board: begins anew.
    void clear();
    void back();
    void forward();

private:
    void onRest();
    void goTo(std::size_t location);

    CameraController& m_controller;
    QTimer m_rest;
    std::vector<render::CameraPose> m_locations;
    std::size_t m_at = 0;
};

}  // namespace ui
