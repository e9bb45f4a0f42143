// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace espalier {

class ParameterEditor;
class ParameterNumber;

/// A parameter's symbol and number below a diagram: the user can tap the number to type another, and
/// double-click the symbol to restore the default.
class ValueField : public QWidget {
    Q_OBJECT

public:
    ValueField(ParameterEditor& editor, const char* key, QWidget* parent = nullptr);

    const char* key() const { return m_key; }
    ParameterNumber& number() const { return *m_number; }

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    ParameterEditor& m_editor;
    const char* m_key;
    ParameterNumber* m_number;
};

} // namespace espalier
