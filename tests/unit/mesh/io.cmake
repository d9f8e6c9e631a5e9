# Readers and writers through VTK and TetGen. The program io_vtk alone links VTK: it writes the files that it reads.
if(HAVS_WITH_VTK)
  find_package(VTK REQUIRED QUIET COMPONENTS CommonCore CommonDataModel IOExodus IOLegacy IOXML)
  havs_test(unit mesh_io_vtk
    SOURCES io_vtk_test.cpp io_vtk_blocks_test.cpp vtu_reader_test.cpp
    LINK havs::mesh VTK::CommonCore VTK::CommonDataModel VTK::IOExodus VTK::IOLegacy VTK::IOXML)
  havs_test(unit mesh_io_files
    SOURCES io_bad_files_test.cpp io_ensight_test.cpp io_plot3d_test.cpp io_shared_data_test.cpp
    LINK havs::mesh)
endif()
if(HAVS_WITH_TETGEN)
  havs_test(unit mesh_io_tetgen
    SOURCES io_tetgen_test.cpp io_tetgen_bad_test.cpp
    LINK havs::mesh)
endif()
