"""Arrays between numpy and the C face: selections, views on loan, values in any layout."""
import ctypes
import weakref

import numpy

from . import _raw
from ._engine import address, points_in, whole


def _ids_in(ids):
    array = numpy.asarray(ids)
    if array.ndim != 1:
        raise ValueError(f"ids are one row of numbers; the array has the shape {array.shape}")
    if array.dtype == bool:
        raise TypeError("ids are numbers of particles, not a mask: give numpy.flatnonzero(mask)")
    if array.dtype.kind not in "iu" and len(array):
        raise TypeError(f"ids are whole numbers; the array is of {array.dtype}")
    if array.dtype.kind == "u" and len(array) and int(array.max()) > numpy.iinfo(numpy.int64).max:
        raise OverflowError(f"there is no particle {array.max()}")
    return numpy.ascontiguousarray(array, dtype=numpy.int64)


class Selection:
    """Which particles; give one: ids, box (xmin, ymin, xmax, ymax), polygon (rows of x, y), material, layer, boundary
    (an id) or soil=True. A box and a polygon are meant in the present shape. ids are whole numbers; of a mask over all
    particles give numpy.flatnonzero(mask)."""

    def __init__(self, ids=None, box=None, polygon=None, material=None, layer=None, boundary=None, soil=False):
        given = [ids is not None, box is not None, polygon is not None, material is not None, layer is not None,
                 boundary is not None, bool(soil)]
        if sum(given) != 1:
            raise ValueError("a selection is by one of ids, box, polygon, material, layer, boundary and soil")
        self._record = r = _raw.vbgpd_selection()
        if ids is not None:
            self._array = _ids_in(ids)
            r.kind, r.ids, r.ids_stride, r.n_ids = (_raw.VBGPD_SELECT_IDS, address(self._array, ctypes.c_int64), 8,
                                                    len(self._array))
        elif box is not None:
            r.kind = _raw.VBGPD_SELECT_BOX
            r.xmin, r.ymin, r.xmax, r.ymax = box
        elif polygon is not None:
            r.kind = _raw.VBGPD_SELECT_POLYGON
            self._array, r.xy, r.xy_stride, r.n_points = points_in(polygon)
        else:
            r.kind = (_raw.VBGPD_SELECT_MATERIAL if material is not None else
                      _raw.VBGPD_SELECT_LAYER if layer is not None else
                      _raw.VBGPD_SELECT_BOUNDARY if boundary is not None else _raw.VBGPD_SELECT_SOIL)
            what, of = next(((name, i) for name, i in (("material", material), ("layer", layer), ("boundary", boundary))
                             if i is not None), ("soil", 0))
            r.object_id = whole(of, ctypes.c_int64, what)

    @property
    def pointer(self):
        return ctypes.byref(self._record)


class _Lease:
    """What numpy arrays of a view hold on to: the last of them gone, the lease ends."""

    def __init__(self, model, record, dtype):
        self._model, self._lease = model, record.lease
        shape, strides = (record.count,), (record.stride_item,)
        if record.components > 1:
            shape, strides = (*shape, record.components), (*strides, record.stride_component)
        self.__array_interface__ = {"version": 3, "data": (record.data, True), "shape": shape, "strides": strides,
                                    "typestr": dtype.str}
        self.alive = True

    def end(self):
        if self.alive:
            self.alive = False
            self._model._end(self._lease)

    __del__ = end


class View:
    """A field of a model as it is stored, padding included; "particle_id" tells which particle an item is, -1 = padding.

        with model.view("displacement") as u, model.view("particle_id") as ids:
            print(abs(u.array[ids.array >= 0]).max())

    `array` is read-only numpy over the memory of the engine. The model does not change (Error with E_LEASED) until the
    view is released and every array taken from it is gone; there is no dangling array.
    """

    def __init__(self, model, info, library):
        record = _raw.vbgpd_view()
        model._call("view_acquire", info.index, ctypes.byref(record))
        self._lease = _Lease(model, record, info.dtype)
        model.__dict__.setdefault("_leases", weakref.WeakSet()).add(self._lease)

    @property
    def array(self):
        if self._lease is None:
            raise ValueError("the view is released")
        return numpy.asarray(self._lease)

    def release(self):
        """Ends the view; arrays taken from it hold the lease until they are gone."""
        self._lease = None

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        self.release()


def values_in(values, components):
    """(array, pointer, stride of items, stride of components) of float64 rows of so many components, in place."""
    array = numpy.asarray(values, dtype=numpy.float64)
    if array.ndim not in (1, 2) or 0 in array.strides:
        array = numpy.ascontiguousarray(array)
    if array.ndim not in (1, 2):
        raise ValueError(f"values are an array of items, or of items and components, not of shape {array.shape}")
    if (array.shape[1] if array.ndim == 2 else 1) != components:
        raise ValueError(f"items of this field have {components} components; the values are of shape {array.shape}")
    return array, address(array), array.strides[0] if len(array) > 1 else 0, array.strides[1] if array.ndim == 2 else 0
