"""A picture by VTK: mesh, transfer function, camera and method as a pipeline. Only what drawing needs is imported, as
starting counts for the first picture."""
import json

import vtkmodules.vtkRenderingOpenGL2  # registers the factories of OpenGL
import vtkmodules.vtkRenderingVolumeOpenGL2
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import (vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume,
                                         vtkVolumeProperty, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingOpenGL2 import vtkFramebufferPass, vtkRenderStepsPass, vtkTextureObject
from vtkmodules.vtkRenderingVolume import (vtkProjectedTetrahedraMapper, vtkUnstructuredGridLinearRayIntegrator,
                                           vtkUnstructuredGridPartialPreIntegration, vtkUnstructuredGridPreIntegration,
                                           vtkUnstructuredGridVolumeRayCastMapper,
                                           vtkUnstructuredGridVolumeZSweepMapper)


def _projected(_threads):
    return vtkProjectedTetrahedraMapper()  # blends into a float framebuffer (its default), then copies to 8 bits


def _caster(mapper_class, integrator):
    def make(threads):
        mapper = mapper_class()
        mapper.SetAutoAdjustSampleDistances(False)
        mapper.SetImageSampleDistance(1.0)  # a ray a pixel
        mapper.SetIntermixIntersectingGeometry(False)
        mapper.SetRayIntegrator(integrator())
        if threads and hasattr(mapper, "SetNumberOfThreads"):
            mapper.SetNumberOfThreads(threads)
        return mapper
    return make


MAPPERS = {
    "vtk-projected": _projected,
    "vtk-bunyk-partial": _caster(vtkUnstructuredGridVolumeRayCastMapper, vtkUnstructuredGridPartialPreIntegration),
    "vtk-bunyk-preintegration": _caster(vtkUnstructuredGridVolumeRayCastMapper, vtkUnstructuredGridPreIntegration),
    "vtk-bunyk-linear": _caster(vtkUnstructuredGridVolumeRayCastMapper, vtkUnstructuredGridLinearRayIntegrator),
    "vtk-zsweep": _caster(vtkUnstructuredGridVolumeZSweepMapper, vtkUnstructuredGridPartialPreIntegration),
}


def read_mesh(path, field):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetPointData().SetActiveScalars(field) < 0:
        raise SystemExit(f"{path} has no field {field}")
    return mesh


def volume_property(transfer):
    """`transfer`: havs's JSON, opacity as extinction, scalars in the data's unit."""
    color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for point in transfer["points"]:
        color.AddRGBPoint(point["scalar"], *point["color"])
        opacity.AddPoint(point["scalar"], point["opacity"])
    prop = vtkVolumeProperty()
    prop.SetColor(color)
    prop.SetScalarOpacity(opacity)
    prop.SetScalarOpacityUnitDistance(transfer["unit_length"])
    prop.SetInterpolationTypeToLinear()
    prop.ShadeOff()
    return prop


class Picture:
    def __init__(self, method, mesh, transfer_file, camera, size, threads):
        with open(transfer_file, encoding="utf-8") as file:
            transfer = json.load(file)
        self.size = size
        self.mapper = MAPPERS[method](threads)
        self.mapper.SetInputData(mesh)
        volume = vtkVolume()
        volume.SetMapper(self.mapper)
        volume.SetProperty(volume_property(transfer))
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0, 0, 0)
        self.renderer.AddVolume(volume)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetShowWindow(False)
        self.window.SetUseOffScreenBuffers(True)
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)
        if isinstance(self.mapper, vtkUnstructuredGridVolumeRayCastMapper):
            # Its rays go through the corners of pixels: half a pixel up and right makes its picture comparable.
            self.renderer.GetActiveCamera().SetWindowCenter(1 / size, 1 / size)
        self.set_camera(camera)

    def set_camera(self, camera):
        """`camera`: as havs reports it, perspective."""
        ours = self.renderer.GetActiveCamera()
        ours.SetPosition(camera["eye"])
        ours.SetFocalPoint(camera["target"])
        ours.SetViewUp(camera["up"])
        ours.SetViewAngle(camera["field_of_view"])
        self.renderer.ResetCameraClippingRange()

    def turn(self, degrees):
        self.renderer.GetActiveCamera().Azimuth(degrees)
        self.renderer.ResetCameraClippingRange()

    def draw(self):
        """Draws, and reads the pixels back (8 bits a channel, all that VTK's window has)."""
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, self.size - 1, self.size - 1, 0, pixels, 0)
        return pixels

    def write_png(self, path):
        image = vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.SetInputBufferTypeToRGB()
        image.ReadFrontBufferOff()
        image.ShouldRerenderOff()
        writer = vtkPNGWriter()
        writer.SetInputConnection(image.GetOutputPort())
        writer.SetFileName(path)
        writer.Write()

    def draw_floats(self, frames):
        """What projected tetrahedra have blended, before it is rounded to 8 bits: the same drawing into a float target.
        RGBA, bytes of floats, the lowest row first; the last of `frames` pictures."""
        into_floats = vtkFramebufferPass()
        into_floats.SetColorFormat(vtkTextureObject.Float32)
        into_floats.SetDelegatePass(vtkRenderStepsPass())
        self.mapper.SetUseFloatingPointFrameBuffer(False)  # its own would come between
        self.renderer.SetPass(into_floats)
        for _ in range(frames):
            self.window.Render()
        pixels = bytearray(16 * self.size * self.size)
        buffer = into_floats.GetColorTexture().Download()
        if not buffer.Download2D(VTK_FLOAT, pixels, [self.size, self.size], 4, [0, 0]):
            raise SystemExit("VTK does not give back its float framebuffer")
        return pixels

    def opengl(self):
        lines = self.window.ReportCapabilities().splitlines()
        find = lambda name: next((l.split(":", 1)[1].strip() for l in lines if l.startswith(f"OpenGL {name} string")), "?")
        return {"window": self.window.GetClassName(), "renderer": find("renderer"), "version": find("version")}
