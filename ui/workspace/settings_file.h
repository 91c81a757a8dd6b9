#pragma once

#include <QString>
#include <QVariant>
#include <map>
#include <memory>

#include "ui/workspace/writing_thread.h"

namespace ui {

/// Values by key that are kept between runs, as QSettings keeps them. They are read when this is made and held in
/// memory; what is set is written on a thread of its own (QSettings waits for the disk each time, where it lives), and
/// what other programs have written to the file meanwhile is then taken over.
class SettingsFile {
public:
    /// Where the system keeps settings; with a path, in that file.
    explicit SettingsFile(const QString& iniFile = {});
    ~SettingsFile();
    SettingsFile(const SettingsFile&) = delete;
    SettingsFile& operator=(const SettingsFile&) = delete;

    [[nodiscard]] QVariant value(const QString& key, const QVariant& other = {}) const;
    void setValue(const QString& key, const QVariant& value);
    void clear();

    /// False: the system does not let them be written, so they end with the program.
    [[nodiscard]] bool isWritable() const { return m_isWritable; }
    /// The file, or what the system has instead of one.
    [[nodiscard]] const QString& path() const { return m_path; }

private:
    struct Exchange;

    void write();

    QString m_iniFile;
    QString m_path;
    bool m_isWritable = false;
    std::map<QString, QVariant> m_values;
    std::shared_ptr<Exchange> m_exchange;
    WritingThread m_thread;
};

}  // namespace ui
