#pragma once

#include <QFrame>

#include "render/gpu/device.h"

namespace ui {

class Settings;

/// A line above the views that says in plain words that no graphics card draws. It is there in one run of the program,
/// until it is closed; afterwards the status bar alone says so.
class DeviceNotice : public QFrame {
    Q_OBJECT

public:
    DeviceNotice(const render::gpu::Caps& caps, Settings& settings, QWidget* parent = nullptr);
};

}  // namespace ui
