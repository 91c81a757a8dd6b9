#include "ui/workspace/settings_file.h"

#include <QSettings>
#include <mutex>
#include <utility>

namespace ui {

namespace {

using Values = std::map<QString, QVariant>;  // QHash would be shared by both threads

std::unique_ptr<QSettings> open(const QString& iniFile) {
    return iniFile.isEmpty() ? std::make_unique<QSettings>(QStringLiteral("Copperscope"), QStringLiteral("Copperscope"))
                             : std::make_unique<QSettings>(iniFile, QSettings::IniFormat);
}

Values allOf(const QSettings& store) {
    Values values;
    for (const QString& key : store.allKeys()) {
        values.emplace(key, store.value(key));
    }
    return values;
}

/// What was set, after all that was there was removed or not.
struct Changes {
    bool areFromEmpty = false;
    Values values;
};

bool isWritten(const Changes& changes, QSettings& store) {
    if (changes.areFromEmpty) {
        store.clear();
    }
    for (const auto& [key, value] : changes.values) {
        store.setValue(key, value);
    }
    store.sync();
    return store.status() == QSettings::NoError;
}

/// Both, one after the other.
Changes inOrder(Changes first, const Changes& second) {
    if (second.areFromEmpty) {
        return second;
    }
    for (const auto& [key, value] : second.values) {
        first.values.insert_or_assign(key, value);
    }
    return first;
}

}  // namespace

/// What both threads see.
struct SettingsFile::Exchange {
    std::mutex mutex;
    Changes changes;       ///< to be written
    Changes beingWritten;  ///< by the thread, which alone changes them
    Values inFile;         ///< when it was written last

    /// What could not be written is tried again with what is set next.
    base::Status write(const QString& iniFile) {
        {
            const std::scoped_lock lock(mutex);
            beingWritten = std::exchange(changes, {});
        }
        const std::unique_ptr<QSettings> store = open(iniFile);
        const bool isDone = isWritten(beingWritten, *store);
        const std::scoped_lock lock(mutex);
        const Changes now = std::exchange(beingWritten, {});
        if (!isDone) {
            changes = inOrder(now, changes);
            return base::Error{base::ErrorCode::OutputFailed, store->fileName().toStdString() + " cannot be written"};
        }
        inFile = allOf(*store);
        return base::Done{};
    }
    Values latest() {
        const std::scoped_lock lock(mutex);
        return inOrder(inOrder({false, inFile}, beingWritten), changes).values;
    }
};

SettingsFile::SettingsFile(const QString& iniFile) : m_iniFile(iniFile), m_exchange(std::make_shared<Exchange>()) {
    const std::unique_ptr<QSettings> store = open(m_iniFile);
    m_path = store->fileName();
    m_isWritable = store->isWritable();
    m_values = allOf(*store);
}

SettingsFile::~SettingsFile() = default;

QVariant SettingsFile::value(const QString& key, const QVariant& other) const {
    const auto held = m_values.find(key);
    return held != m_values.end() ? held->second : other;
}

void SettingsFile::setValue(const QString& key, const QVariant& value) {
    const auto held = m_values.find(key);
    if (held != m_values.end() && held->second == value) {
        return;
    }
    m_values.insert_or_assign(key, value);
    {
        const std::scoped_lock lock(m_exchange->mutex);
        m_exchange->changes.values.insert_or_assign(key, value);
    }
    write();
}

void SettingsFile::clear() {
    m_values.clear();
    {
        const std::scoped_lock lock(m_exchange->mutex);
        m_exchange->changes = {true, {}};
    }
    write();
}

void SettingsFile::write() {
    if (m_isWritable) {
        m_thread.add(
            this, [exchange = m_exchange, iniFile = m_iniFile] { return exchange->write(iniFile); },
            [this](const base::Status& written) {
                if (written) {
                    m_values = m_exchange->latest();
                }
            });
    }
}

}  // namespace ui
