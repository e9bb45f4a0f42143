// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ViewField.h"

#include "panels/ViewRow.h"

namespace espalier {

ViewRow* makeViewRow(const ViewField& field, ViewSettings& settings, QWidget* parent)
{
    auto* row = new ViewRow({field.info, field.text}, parent);
    const auto follow = [row, get = field.get, &settings] {
        if (const double value = get(settings.values()); row->value() != value)
            row->setValue(value);
    };
    QObject::connect(row, &ViewRow::edited, &settings, [set = field.set, &settings](double value) {
        ViewValues values = settings.values();
        set(values, value);
        settings.setValues(values);
    });
    QObject::connect(&settings, &ViewSettings::changed, row, follow);
    row->setValue(field.get(settings.values()));
    row->setUsual(field.get(ViewValues()));
    return row;
}

} // namespace espalier
