#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "model/base/progress.h"

namespace ui {

/// One piece of work at a time on a thread of its own, which gives way to others (base::becomeBackground); what it
/// reports arrives on the thread this lives on. Starting another one cancels the one being done, whose thread winds
/// down unseen. Exactly one of finished and cancelled follows each started, except when this is destroyed.
class Background : public QObject {
    Q_OBJECT

public:
    /// Runs on the thread. It leaves its result where whoever started it finds it.
    using Work = std::function<void(base::Progress&)>;

    explicit Background(QObject* parent = nullptr);
    ~Background() override;

    /// `phase` is shown until the work names one.
    void start(Work work, const char* phase);
    /// Nothing is heard of the work after this.
    void cancel();
    [[nodiscard]] bool isRunning() const { return m_current != nullptr; }

signals:
    void started();
    /// `fraction` of the phase, 0 to 1; a phase is a few plain words.
    void progressed(const QString& phase, double fraction);
    void finished();
    void cancelled();

private:
    struct Job;

    void retire();
    void poll();

    std::unique_ptr<Job> m_current;
    std::vector<std::unique_ptr<Job>> m_retiring;  ///< cancelled, still winding down
    QTimer m_timer;
};

}  // namespace ui
