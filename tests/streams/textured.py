"""python3 textured.py FOLDER: the images of textured.json.

bricks.png is a wall of bricks, brick red on mortar; its lowest row is dark,
so that which way up it stands can be seen. leaves.png has holes in it.
"""
import pathlib
import struct
import sys
import zlib


def png(name, width, height, colour_type, pixel):
    rows = b''.join(
        b'\0' + b''.join(bytes(pixel(x, y)) for x in range(width))
        for y in range(height))

    def chunk(kind, data):
        return (struct.pack('>I', len(data)) + kind + data +
                struct.pack('>I', zlib.crc32(kind + data)))

    head = struct.pack('>IIBBBBB', width, height, 8, colour_type, 0, 0, 0)
    # Pixels that are not square: glTF has viewers ignore it.
    size = struct.pack('>IIB', 3000, 2000, 1)
    (pathlib.Path(sys.argv[1]) / name).write_bytes(
        b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'pHYs', size) +
        chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b''))


def brick(x, y):
    course, row = divmod(y, 8)
    if row == 0 or (x + 8 * (course % 2)) % 16 == 0:
        return 200, 195, 185
    return (70, 60, 60) if course == 3 else (165, 70 + 6 * course, 50)


def leaf(x, y):
    return 60, 120 + 8 * (x ^ y), 40, 255 * ((x + y) % 4 < 2)


png('bricks.png', 32, 32, 2, brick)
png('leaves.png', 8, 8, 6, leaf)
