"""Un PNG dentro de una página, de los bytes de una imagen: los que hacen falta son muchos y pequeños."""
import base64
import struct
import zlib


def trozo(tipo, datos):
    return struct.pack(">I", len(datos)) + tipo + datos + struct.pack(">I", zlib.crc32(tipo + datos))


def en_url(ancho, alto, canales, datos):
    """De sus bytes en base 64, de 1 o 3 canales y fila a fila desde arriba, «data:image/png;base64,…»."""
    bytes_ = base64.b64decode(datos)
    largo = ancho * canales
    filas = b"".join(b"\0" + bytes_[y * largo : (y + 1) * largo] for y in range(alto))
    cabecera = struct.pack(">IIBBBBB", ancho, alto, 8, {1: 0, 3: 2}[canales], 0, 0, 0)
    trozos = trozo(b"IHDR", cabecera), trozo(b"IDAT", zlib.compress(filas)), trozo(b"IEND", b"")
    return "data:image/png;base64," + base64.b64encode(b"\x89PNG\r\n\x1a\n" + b"".join(trozos)).decode()
