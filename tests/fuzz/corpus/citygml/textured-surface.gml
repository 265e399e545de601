<?xml version="1.0"?>
<CityModel xmlns="http://www.opengis.net/citygml/1.0" xmlns:bldg="http://www.opengis.net/citygml/building/1.0" xmlns:tex="http://www.opengis.net/citygml/texturedsurface/1.0" xmlns:gml="http://www.opengis.net/gml" xmlns:xlink="http://www.w3.org/1999/xlink">
<cityObjectMember><bldg:Building gml:id="b"><bldg:lod2MultiSurface><gml:MultiSurface>
<gml:surfaceMember><tex:TexturedSurface gml:id="ts" orientation="+"><gml:baseSurface><gml:Polygon gml:id="p"><gml:exterior><gml:LinearRing><gml:posList>0 0 0 4 0 0 4 4 0 0 4 0 0 0 0</gml:posList></gml:LinearRing></gml:exterior><gml:interior><gml:LinearRing><gml:posList>1 1 0 1 2 0 2 2 0 1 1 0</gml:posList></gml:LinearRing></gml:interior></gml:Polygon></gml:baseSurface>
<tex:appearance><tex:SimpleTexture gml:id="st"><tex:textureMap>wall.png</tex:textureMap><tex:textureCoordinates>0 0 1 0 1 1 0 1 0 0 .25 .25 .25 .5 .5 .5 .25 .25</tex:textureCoordinates><tex:textureType>specific</tex:textureType><tex:repeat>true</tex:repeat></tex:SimpleTexture></tex:appearance>
<tex:appearance orientation="-"><tex:Material gml:id="m"><tex:shininess>0.5</tex:shininess><tex:transparency>0.25</tex:transparency><tex:ambientIntensity>0.1</tex:ambientIntensity><tex:specularColor>0 0 1</tex:specularColor><tex:diffuseColor>1 0 0</tex:diffuseColor></tex:Material></tex:appearance>
</tex:TexturedSurface></gml:surfaceMember>
<gml:surfaceMember><tex:TexturedSurface orientation="-"><gml:baseSurface><gml:Polygon gml:id="q"><gml:exterior><gml:LinearRing><gml:posList>0 0 1 4 0 1 4 4 1 0 4 1 0 0 1</gml:posList></gml:LinearRing></gml:exterior></gml:Polygon></gml:baseSurface><tex:appearance xlink:href="#m"/></tex:TexturedSurface></gml:surfaceMember>
<gml:surfaceMember><tex:TexturedSurface><gml:baseSurface xlink:href="#q"/><tex:appearance xlink:href="#nothing"/></tex:TexturedSurface></gml:surfaceMember>
</gml:MultiSurface></bldg:lod2MultiSurface></bldg:Building></cityObjectMember></CityModel>
