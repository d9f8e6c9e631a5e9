#pragma once
// In place of shaders/filter.glsl on the native device: Table2d, Table3d and fetchTable are in
// render/native/table_fetch.h.
